#include "analysis/dataset/mapped_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/dataset/mapped_notes.h"
#include "analysis/dataset/mapped_table.h"
#include "analysis/dataset/row_digest.h"
#include "oc_core/base/error.h"
#include "study/trial/trial_check.h"

namespace ocelli {
namespace {

constexpr double kStepsPerSecond = 240;
constexpr double kRoundingSeconds = 0.0005;  // tools write milliseconds, and differences of clocks are rounded

/// A trial whose condition, case and block have no numbers yet: these depend on all rows.
struct MappedRow {
  Trial trial{};
  std::string condition{};
  bool isPractice = false;
};

class MappedReading {
 public:
  explicit MappedReading(const ColumnMap& map) : map_(map) {}

  Dataset all(const std::vector<std::string>& paths) {
    checkEachTableIsThereOnce(paths);
    for (const std::string& path : paths) {
      readTable(path);
    }
    checkThereAreTrials(paths);
    numberConditions();
    checkSubjectsOfConditions();
    numberBlocksAndCases();
    fill();
    counts_.tables = paths.size();
    data_.tableFacts = mappedNotes(map_, counts_);
    return std::move(data_);
  }

 private:
  static void checkEachTableIsThereOnce(const std::vector<std::string>& paths);
  void readTable(const std::string& path);
  MappedRow readRow(const MappedTable& table);
  void readOutcome(const MappedTable& table, Trial& trial) const;
  std::optional<double> secondsOf(const MappedTable& table) const;
  bool isTimedOut(const MappedTable& table, const std::optional<double>& seconds) const;
  std::optional<bool> isRight(const MappedTable& table, const Trial& trial) const;
  void checkIsNew(const MappedTable& table, MappedRow& row);
  void checkSubject(const MappedTable& table, const Trial& trial);

  [[noreturn]] void fail(const MappedRow& row, const std::string& column, const std::string& problem,
                         const std::string& next) const {
    throw InputError(fmt::format("column \"{}\" {}", column, problem), placeOf(row.trial), next);
  }
  std::string placeOf(const Trial& trial) const {
    return fmt::format("{}:{}", data_.sources[static_cast<size_t>(trial.source)].path, trial.trialId);
  }

  void checkThereAreTrials(const std::vector<std::string>& paths) const;
  void numberConditions();
  void takeConditionsOfRows();
  void checkSubjectsOfConditions() const;
  void numberBlocksAndCases();
  void fill();

  const ColumnMap& map_;
  Dataset data_{};
  MappedCounts counts_{};
  std::vector<MappedRow> rows_{};
  std::map<std::string, size_t> conditions_{};  ///< place in data_.conditions by the table's value
  using SessionKey = std::pair<std::string, int>;
  std::map<SessionKey, int> lastTrials_{};                         ///< where rows count
  std::map<std::tuple<std::string, int, int>, size_t> numbers_{};  ///< rows, by subject, session and number
  std::map<Digest, std::string> wholeRows_{};                      ///< places, by all fields
  std::map<std::string, size_t> subjects_{};                       ///< first rows of subjects
};

void MappedReading::checkEachTableIsThereOnce(const std::vector<std::string>& paths) {
  std::set<std::string> seen;
  for (const std::string& path : paths) {
    std::error_code ignored;
    if (!seen.insert(std::filesystem::weakly_canonical(path, ignored).string()).second) {
      throw InputError("this table is given twice", path, "each table once");
    }
  }
}

void MappedReading::readTable(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError("this is a folder, and a map of columns is for tables", path, "the CSV files in it");
  }
  MappedTable table(path, map_);
  DataSource source;
  source.path = path;
  source.form = DataSource::Form::kMappedTable;
  source.tool = map_.tool;
  source.columnMap = map_.name;
  source.columnMapSha256 = map_.sha256;
  source.columnMapText = describe(map_);
  source.subjectsAreKnown = map_.subjects != MappedSubjects::kUnknown;
  data_.sources.push_back(std::move(source));
  while (table.next()) {
    ++counts_.rows;
    if (std::all_of(map_.rows.begin(), map_.rows.end(), [&](const RowTest& test) { return table.passes(test); })) {
      MappedRow row = readRow(table);
      checkIsNew(table, row);
      checkSubject(table, row.trial);
      rows_.push_back(std::move(row));
    } else {
      ++counts_.noTrials;
    }
  }
}

MappedRow MappedReading::readRow(const MappedTable& table) {
  MappedRow row;
  Trial& trial = row.trial;
  trial.source = static_cast<int>(data_.sources.size()) - 1;
  trial.trialId = table.line();
  trial.subject = table.name(map_.subject);
  if (!map_.sessionValues.empty()) {
    const std::string value = table.text(map_.session);
    const auto found = std::find(map_.sessionValues.begin(), map_.sessionValues.end(), value);
    if (found == map_.sessionValues.end()) {
      table.fail(map_.session, fmt::format("is \"{}\", which \"session_values\" of the map does not hold", value));
    }
    trial.session = static_cast<int>(found - map_.sessionValues.begin()) + 1;
  } else if (map_.session.isSet()) {
    trial.session = table.wholeNumber(map_.session, 1);
  }
  trial.task = table.name(map_.task);
  trial.block = map_.block.isSet() ? table.name(map_.block) : trial.task;
  trial.simulated = map_.subjects == MappedSubjects::kSimulated || table.passes(map_.simulated);
  trial.subjectKind = trial.simulated ? SubjectKind::kGenerator : SubjectKind::kPerson;
  row.isPractice = table.passes(map_.practice);
  if (row.isPractice) {
    row.condition = table.text(map_.condition);
    return row;
  }
  row.condition = table.name(map_.condition);
  trial.caseLabel = table.name(map_.caseLabel);
  trial.ending = TrialEnding::kCompleted;
  readOutcome(table, trial);
  return row;
}

void MappedReading::readOutcome(const MappedTable& table, Trial& trial) const {
  const std::optional<double> seconds = secondsOf(table);
  const bool isCutOff = isTimedOut(table, seconds);
  if (map_.timeout.isSet()) {
    trial.censored = isCutOff;
  }
  trial.longestSeconds = map_.timeout.limitSeconds;
  trial.responseSeconds = seconds;
  if (!seconds && isCutOff) {
    if (!map_.timeout.limitSeconds) {
      table.fail(
          map_.time.column, "is empty as the trial's time ran out, and the map does not say after how many seconds",
          "\"limit_seconds\" in \"timeout\" of a map of your own: its \"base\" is one that comes with the program");
    }
    trial.responseSeconds = map_.timeout.limitSeconds;
  }
  if (!trial.responseSeconds) {
    table.fail(map_.time.column, fmt::format("is \"{}\", but a trial needs a time", table.field(map_.time.column)),
               "a \"timeout\" in the map that says which trials were cut off; or \"rows\" that leaves this one out");
  }
  trial.responseTicks = std::llround(std::min(*trial.responseSeconds, 1e9) * kStepsPerSecond);
  trial.answer = table.text(map_.answer);
  trial.expected = table.text(map_.expected);
  trial.correct = isRight(table, trial);
  for (const auto& [name, column] : map_.measures) {
    if (const std::optional<double> value = table.number(column)) {
      trial.measures[name] = *value;
    }
  }
  if (const auto problem = problemOf(trial)) {
    const auto measure = map_.measures.find(problem->column);
    table.fail(measure == map_.measures.end() ? map_.time.column : measure->second, problem->problem);
  }
}

std::optional<double> MappedReading::secondsOf(const MappedTable& table) const {
  std::optional<double> time = table.number(map_.time.column);
  if (time && !map_.time.minus.empty()) {
    const std::optional<double> begin = table.number(map_.time.minus);
    if (!begin) {
      table.fail(map_.time.minus, "is empty, but tells when the trial began");
    }
    *time -= *begin;
  }
  if (!time) {
    return std::nullopt;
  }
  if (*time < 0) {
    table.fail(map_.time.column,
               fmt::format("{}is {:.6g}, but no time is negative",
                           map_.time.minus.empty() ? "" : fmt::format("less column \"{}\" ", map_.time.minus), *time));
  }
  return *time * map_.time.secondsOfUnit;
}

bool MappedReading::isTimedOut(const MappedTable& table, const std::optional<double>& seconds) const {
  const MappedTimeout& timeout = map_.timeout;
  if (timeout.column.empty()) {
    return timeout.limitSeconds && seconds && *seconds >= *timeout.limitSeconds - kRoundingSeconds;
  }
  const std::string field = table.field(timeout.column);
  return std::find(timeout.is.begin(), timeout.is.end(), field) != timeout.is.end();
}

std::optional<bool> MappedReading::isRight(const MappedTable& table, const Trial& trial) const {
  if (map_.correct.column.empty()) {
    return map_.answer.isSet() && map_.expected.isSet() ? std::optional(trial.answer == trial.expected) : std::nullopt;
  }
  const auto holds = [](const std::vector<std::string>& list, const std::string& field) {
    return std::find(list.begin(), list.end(), field) != list.end();
  };
  const std::string field = table.field(map_.correct.column);
  if (holds(map_.correct.right, field) || holds(map_.correct.wrong, field)) {
    return holds(map_.correct.right, field);
  }
  if (trial.censored.value_or(false) && (field.empty() || field == "null")) {  // nobody judged what was not answered
    return false;
  }
  table.fail(map_.correct.column, fmt::format("is \"{}\", which is neither right nor wrong by the map", field));
}

void MappedReading::checkIsNew(const MappedTable& table, MappedRow& row) {
  Trial& trial = row.trial;
  if (map_.trial.isSet()) {
    trial.planIndex = table.wholeNumber(map_.trial, 0);
    const auto [at, isNew] = numbers_.try_emplace({trial.subject, trial.session, trial.planIndex}, rows_.size());
    if (!isNew) {
      table.fail(map_.trial,
                 fmt::format("is {} a second time for subject \"{}\" in session {}: as in {}", trial.planIndex,
                             trial.subject, trial.session, placeOf(rows_[at->second].trial)),
                 "each table once; or a map whose \"session\" and \"trial\" tell these rows apart (\"trial\": null "
                 "counts rows)");
    }
  } else {
    RowBytes bytes("row");
    for (const std::string& field : table.fields()) {
      bytes.text(field);
    }
    const auto [at, isNew] = wholeRows_.try_emplace(bytes.digest(), placeOf(trial));
    if (!isNew) {
      throw InputError(fmt::format("this row is the same in all columns as {}", at->second), placeOf(trial),
                       "each row once; or a column that tells them apart, as \"trial\" of the map");
    }
    trial.planIndex = lastTrials_[{trial.subject, trial.session}]++;
  }
  trial.trialNumber = trial.planIndex;
}

void MappedReading::checkSubject(const MappedTable& table, const Trial& trial) {
  const auto [at, isNew] = subjects_.try_emplace(trial.subject, rows_.size());
  if (!isNew && rows_[at->second].trial.simulated != trial.simulated) {
    const Trial& first = rows_[at->second].trial;
    table.fail(map_.simulated.column,
               fmt::format("says that subject \"{}\" is {}, but {} says the contrary", trial.subject,
                           trial.simulated ? "simulated" : "not simulated", placeOf(first)));
  }
}

void MappedReading::checkThereAreTrials(const std::vector<std::string>& paths) const {
  if (std::all_of(rows_.begin(), rows_.end(), [](const MappedRow& row) { return row.isPractice; })) {
    std::string columns;
    for (const RowTest& test : map_.rows) {
      columns += fmt::format("{}\"{}\"", columns.empty() ? "" : ", ", test.column);
    }
    throw InputError(
        counts_.rows == 0 ? std::string("there is no row below the names of the columns")
                          : fmt::format("none of the {} rows is a trial by the map{}", counts_.rows,
                                        columns.empty() ? "" : fmt::format(", which looks at column {}", columns)),
        paths.empty() ? "the command" : fmt::format("{}:{}", paths.front(), counts_.rows == 0 ? 1 : 2),
        counts_.rows == 0 ? "a table with a row a trial" : "a map whose \"rows\" and \"practice\" fit the table");
  }
}

void MappedReading::takeConditionsOfRows() {
  std::map<std::string, const MappedRow*> values;
  for (const MappedRow& row : rows_) {
    if (!row.isPractice && values.try_emplace(row.condition, &row).second && values.size() > kMaxConditions) {
      fail(row, map_.condition.column,
           fmt::format("is \"{}\", the {}th condition, and a study has at most {}", row.condition, values.size(),
                       kMaxConditions),
           "another column for \"condition\" in the map");
    }
  }
  std::map<std::string, std::string> named;
  for (const auto& [value, row] : values) {
    const std::string name = conditionNameFrom(value);
    const auto [at, isNew] = named.try_emplace(name, value);
    if (name.empty() || !isNew) {
      fail(*row, map_.condition.column,
           name.empty()
               ? fmt::format("is \"{}\", of which no name can be made", value)
               : fmt::format("is \"{}\", which would have the same name as \"{}\": {}", value, at->second, name),
           "\"conditions\" in the map, which gives names");
    }
    conditions_[value] = data_.conditions.list.size();
    data_.conditions.list.push_back({name, value});
  }
}

void MappedReading::numberConditions() {
  data_.conditions = {};
  std::set<std::string> missing;
  for (const MappedCondition& condition : map_.conditions) {
    conditions_[condition.value] = data_.conditions.list.size();
    data_.conditions.list.push_back({condition.name, condition.label});
    missing.insert(condition.value);
  }
  if (map_.conditions.empty()) {
    takeConditionsOfRows();
  }
  for (MappedRow& row : rows_) {
    if (row.isPractice) {
      continue;
    }
    const auto found = conditions_.find(row.condition);
    if (found == conditions_.end()) {
      std::string known;
      for (const MappedCondition& condition : map_.conditions) {
        known += fmt::format("{}{}", known.empty() ? "" : ", ", condition.value);
      }
      fail(row, map_.condition.column,
           fmt::format("is \"{}\", but \"conditions\" of the map has: {}", row.condition, known),
           fmt::format("correct the row, or the map of columns ({})", map_.name));
    }
    row.trial.view = conditionAt(found->second);
    missing.erase(row.condition);
  }
  counts_.reference = data_.conditions.list.front().label;
  counts_.noCondition.assign(missing.begin(), missing.end());
}

/// What one subject alone has is a slip of the pen, or cannot be told from the subject.
void MappedReading::checkSubjectsOfConditions() const {
  std::map<TrialView, std::set<std::string>> having;
  std::map<TrialView, const MappedRow*> first;
  std::set<std::string> subjects;
  for (const MappedRow& row : rows_) {
    if (!row.isPractice) {
      having[row.trial.view].insert(row.trial.subject);
      first.try_emplace(row.trial.view, &row);
      subjects.insert(row.trial.subject);
    }
  }
  for (const auto& [view, of] : having) {
    if (of.size() == 1 && subjects.size() > 1) {
      const MappedRow& row = *first.at(view);
      fail(row, map_.condition.column,
           fmt::format("is \"{}\", which no subject but \"{}\" has, of {}: it cannot be told from the subject",
                       row.condition, *of.begin(), subjects.size()),
           "correct the value; or a test in \"rows\" of the map that leaves these rows out");
    }
  }
}

void MappedReading::numberBlocksAndCases() {
  std::map<std::string, std::set<std::string>> casesOfBlocks;
  std::map<std::string, const MappedRow*> firstOfBlocks;
  for (const MappedRow& row : rows_) {
    std::set<std::string>& cases = casesOfBlocks[row.trial.block];
    const MappedRow& first = *firstOfBlocks.try_emplace(row.trial.block, &row).first->second;
    if (first.trial.task != row.trial.task) {
      fail(row, map_.block.column,
           fmt::format("is \"{}\" with task \"{}\", but in {} with task \"{}\": a block has one task", row.trial.block,
                       row.trial.task, placeOf(first.trial), first.trial.task),
           "another column for \"block\" or \"task\" in the map");
    }
    if (!row.isPractice) {
      cases.insert(row.trial.caseLabel);
    }
  }
  std::map<std::string, int> blocks;
  std::map<std::string, std::map<std::string, int>> numbers;
  for (const auto& [block, cases] : casesOfBlocks) {
    blocks.emplace(block, static_cast<int>(blocks.size()));
    counts_.cases += static_cast<int64_t>(cases.size());
    for (const std::string& label : cases) {
      std::map<std::string, int>& ofBlock = numbers[block];
      ofBlock.emplace(label, static_cast<int>(ofBlock.size()));
    }
  }
  for (MappedRow& row : rows_) {
    row.trial.blockIndex = blocks.at(row.trial.block);
    if (!row.isPractice) {
      row.trial.caseIndex = numbers.at(row.trial.block).at(row.trial.caseLabel);
    }
  }
}

void MappedReading::fill() {
  std::map<SessionKey, Session> sessions;
  std::map<std::string, Subject> subjects;
  for (MappedRow& row : rows_) {
    Trial& trial = row.trial;
    Subject& subject = subjects[trial.subject];
    if (subject.id.empty()) {
      subject.source = trial.source;
      subject.id = trial.subject;
      subject.kind = trial.subjectKind;
      subject.simulated = trial.simulated;
    }
    Session& session = sessions[{trial.subject, trial.session}];
    if (session.runs == 0) {
      session.source = trial.source;
      session.subject = trial.subject;
      session.number = trial.session;
      session.simulated = trial.simulated;
      session.runs = 1;
    }
    if (row.isPractice) {
      data_.otherAttempts.push_back({trial.source, trial.trialId, trial.subject, trial.session, trial.blockIndex,
                                     trial.block, trial.simulated, OtherAttempt::Why::kPractice, trial.correct,
                                     row.condition});
      continue;
    }
    ++session.completedTrials;
    trial.digest = digestOf(trial, data_.conditions.nameOf(trial.view));
    data_.trials.push_back(std::move(trial));
  }
  for (auto& [id, subject] : subjects) {
    data_.subjects.push_back(std::move(subject));
  }
  for (auto& [key, session] : sessions) {
    data_.sessions.push_back(std::move(session));
  }
  data_.consentIsKnown = false;
  data_.endingsAreKnown = false;
  data_.timeoutsAreKnown = map_.timeout.isSet();
}

}  // namespace

Dataset readMappedTables(const std::vector<std::string>& paths, const ColumnMap& map) {
  return MappedReading(map).all(paths);
}

}  // namespace ocelli
