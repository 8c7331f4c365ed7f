#include "tests/analysis_report/section_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/report/report_task.h"

namespace ocelli::test {
namespace {

/// Sections write marks where a study has the names of its view conditions.
std::string named(const std::string& text) {
  return withViewNames(text, defaultConditions());
}

const ReportCell* findCellOf(const ReportDocument& document, const std::string& table, const std::string& row,
                             const std::string& column) {
  for (const std::vector<ReportElement>* part : {&document.elements, &document.supplement}) {
    for (const ReportElement& element : *part) {
      const auto* found = std::get_if<ReportTable>(&element);
      if (found == nullptr || found->id != table) {
        continue;
      }
      for (const std::vector<ReportCell>& cells : found->rows) {
        for (size_t i = 0; i < cells.size() && (named(cells.front().text) == row || cells.front().shortName == row);
             ++i) {
          const ReportColumn& head = found->columns[i];
          const std::string title = head.group.empty() ? head.title : fmt::format("{} {}", head.group, head.title);
          if (column == named(title)) {
            return &cells[i];
          }
        }
      }
    }
  }
  return nullptr;
}

}  // namespace

SectionStudy::SectionStudy(int plannedSessions) {
  DataSource source;
  source.path = "made.db";
  if (plannedSessions > 0) {
    source.protocolText = fmt::format(R"({{"name": "made", "sessions": {}, "blocks": []}})", plannedSessions);
  }
  analysis.data.sources = {source};
  analysis.plan = defaultPlan();
}

Trial& SectionStudy::add(const std::string& subject, int session, TrialView view, double seconds, bool correct,
                         const std::string& task) {
  Trial trial;
  trial.trialId = static_cast<int64_t>(analysis.data.trials.size()) + 1;
  trial.subject = subject;
  trial.session = session;
  trial.planIndex = static_cast<int>(analysis.data.trials.size());
  trial.task = task;
  trial.block = fmt::format("{} stationary", task);
  trial.blockIndex = task == "find" ? 0 : task == "count" ? 1 : 2;
  trial.view = view;
  trial.moving = false;
  trial.longestSeconds = 60;
  trial.correct = correct;
  trial.censored = task == "find" && !correct;
  trial.responseSeconds = seconds;
  return analysis.data.trials.emplace_back(trial);
}

void SectionStudy::complete(const std::string& subject, int sessions) {
  for (int number = 1; number <= sessions; ++number) {
    Session session;
    session.subject = subject;
    session.number = number;
    session.ending = SessionEnding::kCompleted;
    analysis.data.sessions.push_back(session);
  }
}

std::vector<ReportTask> rowsOf(const std::vector<std::string>& tasks) {
  std::vector<ReportTask> rows;
  std::transform(tasks.begin(), tasks.end(), std::back_inserter(rows),
                 [](const std::string& name) { return reportTask(name); });
  return rows;
}

ReportDocument documentOf(const AnalysisData& analysis, const std::function<void(ReportWork&)>& addSection) {
  ReportDocument document;
  for (const DataSource& source : analysis.data.sources) {
    document.origins.sources.push_back(source.path);
  }
  ReportWork work{analysis, document};
  addSection(work);
  return document;
}

std::string cellText(const ReportDocument& document, const std::string& table, const std::string& row,
                     const std::string& column) {
  const ReportCell* cell = findCellOf(document, table, row, column);
  return cell == nullptr ? "no such cell" : cell->text;
}

std::optional<double> cellValue(const ReportDocument& document, const std::string& table, const std::string& row,
                                const std::string& column) {
  const ReportCell* cell = findCellOf(document, table, row, column);
  return cell == nullptr ? std::nullopt : cell->value;
}

std::vector<std::string> reasonsOf(const ReportDocument& document) {
  std::vector<std::string> reasons;
  for (const ReportElement& element : document.elements) {
    const auto* note = std::get_if<ReportNote>(&element);
    if (note != nullptr && note->kind == NoteKind::kNotEstimable) {
      reasons.push_back(named(note->text));
    }
  }
  return reasons;
}

bool hasFigure(const ReportDocument& document, const std::string& id) {
  return std::any_of(document.elements.begin(), document.elements.end(), [&](const ReportElement& element) {
    const auto* figure = std::get_if<ReportFigure>(&element);
    return figure != nullptr && figure->id == id;
  });
}

const Cell& originOf(const ReportDocument& document, const std::string& cell) {
  const Cell* found = findCell(document.origins.tables, cell);
  if (found == nullptr) {
    throw std::runtime_error("no cell has the name " + cell);
  }
  return *found;
}

}  // namespace ocelli::test
