#include "analysis/tables/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "oc_core/base/error.h"
#include "study/trial/estimated_value.h"
#include "study/trial/level_measures.h"

namespace ocelli {
namespace {

/// For a shell: in single quotes.
std::string shellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

/// One line, whatever people typed.
std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

size_t commonStart(const std::string& a, const std::string& b) {
  return static_cast<size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

[[noreturn]] void throwNoSuchCell(const std::vector<Table>& tables, const std::string& name) {
  std::vector<std::string> names;
  for (const Table& table : tables) {
    for (const TableRow& row : table.rows) {
      std::transform(row.cells.begin(), row.cells.end(), std::back_inserter(names),
                     [](const Cell& cell) { return cell.name; });
    }
  }
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return commonStart(a, name) > commonStart(b, name);
  });
  std::string close;
  for (size_t i = 0; i < std::min<size_t>(names.size(), 5); ++i) {
    close += fmt::format("{}{}", i == 0 ? "" : ", ", names[i]);
  }
  throw InputError("no table has this cell", oneLine(name),
                   close.empty() ? "another cell" : fmt::format("one of the names of cells, such as {}", close));
}

/// What estimates and thresholds come from: "estimate_m 3.25, truth_m 4"; empty where a trial has none of it.
std::string measuresText(const Trial& trial) {
  std::map<std::string, double> told;
  if (const std::optional<EstimatedValue> value = estimatedValue(trial.measures)) {
    told = measuresOf(*value);
  }
  for (const char* name : {kLevelMeasure, kGuessRateMeasure}) {
    if (const auto found = trial.measures.find(name); found != trial.measures.end()) {
      told.insert(*found);
    }
  }
  std::string text;
  for (const auto& [name, value] : told) {
    text += fmt::format("{}{} {:.6g}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

void appendTrials(std::string& text, const Cell& cell, const Dataset& data) {
  std::map<RowRef, const Trial*> trials;
  bool anyMeasures = false;
  for (const Trial& trial : data.trials) {
    trials[{trial.source, trial.trialId}] = &trial;
  }
  for (const RowRef& row : cell.rows) {
    const auto found = trials.find(row);
    anyMeasures = anyMeasures || (found != trials.end() && !measuresText(*found->second).empty());
  }
  text +=
      fmt::format("source  trial_id  subject  session  case  view  response_s  time over  right  answer  expected{}\n",
                  anyMeasures ? "  measures" : "");
  const auto flag = [](const std::optional<bool>& value) { return !value ? "-" : *value ? "yes" : "no"; };
  for (const RowRef& row : cell.rows) {
    const auto found = trials.find(row);
    if (found == trials.end()) {
      fmt::format_to(std::back_inserter(text), "{}  {}  (not in these data)\n", row.source + 1, row.row);
      continue;
    }
    const Trial& trial = *found->second;
    const std::string measures = measuresText(trial);
    fmt::format_to(std::back_inserter(text), "{}  {}  {}  {}  {}/{}  {}  {}  {}  {}  {}  {}{}\n", row.source + 1,
                   row.row, oneLine(trial.subject), trial.session, oneLine(trial.block), oneLine(trial.caseLabel),
                   data.conditions.nameOf(trial.view),
                   trial.responseSeconds ? fmt::format("{:.6g}", *trial.responseSeconds) : "-", flag(trial.censored),
                   flag(trial.correct), oneLine(trial.answer), oneLine(trial.expected),
                   measures.empty() ? "" : "  " + measures);
  }
}

void appendAnswers(std::string& text, const Cell& cell, const Dataset& data) {
  std::map<RowRef, const FormAnswer*> answers;
  for (const FormAnswer& answer : data.answers) {
    answers[{answer.source, answer.answerId}] = &answer;
  }
  text += "source  answer_id  subject  session  question  answer\n";
  for (const RowRef& row : cell.rows) {
    const auto found = answers.find(row);
    if (found != answers.end()) {
      const FormAnswer& answer = *found->second;
      fmt::format_to(std::back_inserter(text), "{}  {}  {}  {}  {}/{}  {}\n", row.source + 1, row.row,
                     oneLine(answer.subject), answer.session, oneLine(answer.form), oneLine(answer.field),
                     oneLine(answer.answer));
    }
  }
}

}  // namespace

std::string queryOf(const Cell& cell, const DataSource& source, int sourceIndex) {
  const bool ofTrials = cell.from == Cell::From::kTrials;
  if (source.form != DataSource::Form::kDatabase || (!ofTrials && cell.from != Cell::From::kAnswers)) {
    return "";
  }
  std::string list;
  for (const RowRef& row : cell.rows) {
    if (row.source == sourceIndex) {
      fmt::format_to(std::back_inserter(list), "{}{}", list.empty() ? "" : ", ", row.row);
    }
  }
  return list.empty()
             ? ""
             : fmt::format("sqlite3 -readonly {} \"SELECT * FROM {} WHERE {} IN ({})\"", shellQuoted(source.path),
                           ofTrials ? "final_trial" : "final_answer", ofTrials ? "trial_id" : "answer_id", list);
}

std::string explainCell(const std::vector<Table>& tables, const Dataset& data, const std::string& name) {
  const Cell* cell = findCell(tables, name);
  if (cell == nullptr) {
    throwNoSuchCell(tables, name);
  }
  std::string text = fmt::format("{}: {}\n{}\n", cell->name, displayText(*cell), oneLine(cell->meaning));
  switch (cell->from) {
    case Cell::From::kText:
      text += "It is published: from the text of the dissertation, not from these data.\n";
      return text;
    case Cell::From::kCells:
      for (const std::string& part : cell->cells) {
        text += fmt::format("\nfrom {}", explainCell(tables, data, part));
      }
      return text;
    case Cell::From::kSubjects:
      for (const std::string& subject : cell->subjects) {
        text += fmt::format("{}\n", oneLine(subject));
      }
      return text;
    case Cell::From::kTrials:
    case Cell::From::kAnswers:
      break;
  }
  for (size_t i = 0; i < data.sources.size(); ++i) {
    text += fmt::format("source {}: {}\n", i + 1, oneLine(data.sources[i].path));
    const std::string query = queryOf(*cell, data.sources[i], static_cast<int>(i));
    text += query.empty() ? "" : fmt::format("  {}\n", query);
  }
  if (cell->from == Cell::From::kTrials) {
    appendTrials(text, *cell, data);
  } else {
    appendAnswers(text, *cell, data);
  }
  return text;
}

}  // namespace ocelli
