#include "analysis/dataset/mapped_notes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ocelli {
namespace {

std::string quoted(const std::vector<std::string>& values) {
  std::string text;
  for (const std::string& value : values) {
    text += text.empty() ? "" : " or ";
    text += value.empty() ? std::string("nothing") : fmt::format("\"{}\"", value);
  }
  return text;
}

std::string describe(const MappedText& text, const char* otherwise) {
  return text.isFileName        ? std::string("the file's name")
         : !text.column.empty() ? fmt::format("column {}", text.column)
         : !text.value.empty()  ? fmt::format("\"{}\" in all rows", text.value)
                                : std::string(otherwise);
}

std::string describe(const RowTest& test) {
  return fmt::format("column {} {} {}", test.column, test.is.empty() ? "is not" : "is",
                     quoted(test.is.empty() ? test.isNot : test.is));
}

std::string describe(const MappedTime& time) {
  return fmt::format("column {}{}, in {}", time.column, time.minus.empty() ? "" : fmt::format(" less {}", time.minus),
                     time.secondsOfUnit == 1 ? "seconds" : "milliseconds");
}

std::string describe(const ColumnMap& map, const MappedTimeout& timeout) {
  if (!timeout.isSet()) {
    return "none";
  }
  std::vector<std::string> parts;
  if (!timeout.column.empty()) {
    parts.push_back(fmt::format("column {} is {}", timeout.column, quoted(timeout.is)));
  }
  if (timeout.limitSeconds) {
    parts.push_back(timeout.column.empty() ? fmt::format("{} is {:g} s or more", map.time.column, *timeout.limitSeconds)
                                           : fmt::format("limit {:g} s", *timeout.limitSeconds));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string rightAnswersOf(const ColumnMap& map) {
  if (!map.correct.column.empty()) {
    return fmt::format("column {} is {}", map.correct.column, quoted(map.correct.right));
  }
  return map.answer.isSet() && map.expected.isSet() ? "the answer is the expected one" : "not told";
}

}  // namespace

std::string describe(const ColumnMap& map) {
  std::vector<std::string> parts{
      fmt::format("subject: {}", describe(map.subject, "")),
      fmt::format("session: {}", describe(map.session, "1 for all rows")),
      fmt::format("task: {}", describe(map.task, "")),
      fmt::format("block: {}", describe(map.block, "the task")),
      fmt::format("condition: {}", describe(map.condition, "")),
      fmt::format("case: {}", describe(map.caseLabel, "")),
      fmt::format("trial: {}", describe(map.trial, "the order of the rows")),
      fmt::format("time: {}", describe(map.time)),
      fmt::format("answer: {}", describe(map.answer, "not told")),
      fmt::format("right: {}", rightAnswersOf(map)),
      fmt::format("time ran out: {}", describe(map, map.timeout)),
  };
  for (const auto& [name, column] : map.measures) {
    parts.push_back(fmt::format("{}: column {}", name, column));
  }
  for (const RowTest& test : map.rows) {
    parts.push_back(fmt::format("rows that are trials: {}", describe(test)));
  }
  if (map.practice.isSet()) {
    parts.push_back(fmt::format("practice: {}", describe(map.practice)));
  }
  if (map.simulated.isSet()) {
    parts.push_back(fmt::format("simulated: {}", describe(map.simulated)));
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<std::string> mappedNotes(const ColumnMap& map, const MappedCounts& counts) {
  std::vector<std::string> notes;
  notes.push_back(fmt::format("These trials were recorded by {} and read from {} by the map of columns {}.", map.tool,
                              counts.tables == 1 ? std::string("a table") : fmt::format("{} tables", counts.tables),
                              map.name));
  notes.push_back(fmt::format(
      "Such tables do not tell the protocol and its counterbalancing, {}seeds, screens and the timing of frames, "
      "consent, "
      "how sessions ended, and who or what was left out before the tables were written: none of it is in this report.",
      map.timeout.limitSeconds ? "" : "the limits of times, "));
  if (!map.timeout.isSet()) {
    notes.emplace_back(
        "The map names no time-outs, so every time counts as that of a response: if a limit cut trials off, times are "
        "too short.");
  }
  if (map.subjects == MappedSubjects::kUnknown) {
    notes.emplace_back("The map does not say whether the subjects are people or simulated.");
  } else {
    notes.push_back(fmt::format("That the subjects are {} is what the map says{}.",
                                map.subjects == MappedSubjects::kPeople ? "people" : "simulated",
                                map.simulated.isSet() ? ", but for the rows that it marks as simulated" : ""));
  }
  if (counts.noTrials > 0) {
    notes.push_back(
        fmt::format("{} of {} rows are no trials by the map, and are in no number.", counts.noTrials, counts.rows));
  }
  if (map.conditions.empty()) {
    notes.push_back(
        fmt::format("The map gives no order of conditions: \"{}\" is the reference because it is the first by the "
                    "alphabet.",
                    counts.reference));
  }
  if (!counts.noCondition.empty()) {
    notes.push_back(fmt::format("No trial has the condition {} of the map.", quoted(counts.noCondition)));
  }
  if (counts.cases == 1) {
    notes.emplace_back("All trials are of one case, so nothing tells whether the results hold for other cases.");
  }
  return notes;
}

}  // namespace ocelli
