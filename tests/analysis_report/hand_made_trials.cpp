#include "tests/analysis_report/hand_made_trials.h"

#include <fmt/format.h>

namespace ocelli::test {

const Trial* HandMadeTrials::add(const HandMadeTrial& made) {
  Trial trial;
  trial.trialId = static_cast<int64_t>(trials_.size()) + 1;
  trial.task = task_;
  trial.block = fmt::format("{} block", task_);
  trial.subject = made.subject;
  trial.session = made.session;
  trial.planIndex = made.planIndex;
  trial.caseIndex = made.caseIndex;
  trial.caseLabel = fmt::format("case {}", made.caseIndex + 1);
  trial.view = made.view;
  trial.correct = made.correct;
  trial.exposureSeconds = made.exposure;
  trial.duplicateColors = made.duplicates;
  trial.censored = made.censored;
  trial.droppedFrames = made.dropped;
  trial.responseSeconds = made.seconds;
  trial.attempt = made.attempt;
  trials_.push_back(trial);
  list_.push_back(&trials_.back());
  return list_.back();
}

std::vector<int64_t> idsOf(const TrialList& trials) {
  std::vector<int64_t> ids;
  for (const Trial* trial : trials) {
    ids.push_back(trial->trialId);
  }
  return ids;
}

const ReportTable* findTable(const ReportDocument& document, const std::string& id) {
  for (const ReportElement& element : document.elements) {
    if (const auto* table = std::get_if<ReportTable>(&element); table && table->id == id) {
      return table;
    }
  }
  return nullptr;
}

const ReportCell* findCell(const ReportTable& table, const std::string& label, size_t column) {
  for (const std::vector<ReportCell>& row : table.rows) {
    if (withViewNames(row.front().text, defaultConditions()) == label) {
      return &row[column];
    }
  }
  return nullptr;
}

std::vector<std::string> notesOf(const ReportDocument& document) {
  std::vector<std::string> notes;
  for (const ReportElement& element : document.elements) {
    if (const auto* note = std::get_if<ReportNote>(&element)) {
      notes.push_back(withViewNames(note->text, defaultConditions()));
    }
  }
  return notes;
}

}  // namespace ocelli::test
