#include "study/trial/stored_row.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>

#include "oc_core/base/error.h"
#include "study/trial/trial_check.h"

namespace ocelli {
namespace {

constexpr const char* kAsWritten = "the database as the study wrote it";

/// Reads the next column into a field, whose type says which values it may have.
class FieldReader {
 public:
  FieldReader(StoredRow& row, const ViewConditions& conditions) : row_(row), conditions_(conditions) {}

  void read(std::string& field) const { field = row_.text(); }
  void read(int64_t& field) const { field = row_.optionalInteger().value_or(0); }
  void read(bool& field) const { field = row_.flag(); }
  void read(std::optional<bool>& field) const { field = row_.optionalFlag(); }
  void read(std::optional<int>& field) const { field = row_.optionalSmallInteger(); }
  void read(std::optional<int64_t>& field) const { field = row_.optionalInteger(); }
  void read(std::optional<double>& field) const { field = row_.optionalReal(); }
  void read(std::map<std::string, double>& field) const { field = row_.measures(); }
  void read(std::optional<TrialEnding>& field) const { field = row_.optionalWord(kTrialEndings); }
  void read(std::optional<TimingVerdict>& field) const { field = row_.optionalWord(kTimingVerdicts); }
  void read(std::optional<ExposureRule>& field) const { field = row_.optionalWord(kExposureRules); }
  void read(std::optional<uint64_t>& field) const {
    const std::optional<int64_t> bits = row_.optionalInteger();
    field = bits ? std::optional(static_cast<uint64_t>(*bits)) : std::nullopt;
  }
  void read(TrialView& field) const {
    const std::string name = row_.text();
    const std::optional<TrialView> view = conditions_.viewNamed(name);
    if (!view) {
      row_.failAtLast(fmt::format("is \"{}\", but {}", name, conditions_.mustBe()));
    }
    field = *view;
  }

 private:
  StoredRow& row_;
  const ViewConditions& conditions_;
};

}  // namespace

void StoredRow::fail(const std::string& column, const std::string& problem) const {
  throw InputError(fmt::format("{} {}", column, problem), place(), kAsWritten);
}

std::string StoredRow::place() const {
  const SQLite::Column first = statement_.getColumn(0);
  return fmt::format("{}, {} {}", path_.string(), first.getName(), first.getString());
}

void StoredRow::failAtLast(const std::string& problem) const {
  fail(statement_.getColumn(column_ - 1).getName(), problem);
}

std::string StoredRow::text() {
  const SQLite::Column column = next();
  if (!column.isText() && !column.isNull()) {
    failAtLast("is no text");
  }
  return column.getString();
}

std::string StoredRow::name() {
  const std::string value = text();
  if (const std::string problem = problemOfName(value); !problem.empty()) {
    failAtLast(problem);
  }
  return value;
}

int64_t StoredRow::integer() {
  const SQLite::Column column = next();
  if (!column.isInteger()) {
    failAtLast("must be a whole number");
  }
  return column.getInt64();
}

int StoredRow::smallInteger() {
  const int64_t value = integer();
  if (value < 0 || value > std::numeric_limits<int>::max()) {
    failAtLast(fmt::format("is {}, but must be from 0 to {}", value, std::numeric_limits<int>::max()));
  }
  return static_cast<int>(value);
}

double StoredRow::real() {
  const std::optional<double> value = optionalReal();
  if (!value) {
    failAtLast("must be a number");
  }
  return *value;
}

std::optional<double> StoredRow::optionalReal() {
  const SQLite::Column column = next();
  if (column.isNull()) {
    return std::nullopt;
  }
  if (!column.isFloat() && !column.isInteger()) {
    failAtLast("must be a number");
  }
  return column.getDouble();
}

std::optional<std::string> StoredRow::optionalText() {
  const bool missing = isNull();
  const std::string value = text();
  return missing ? std::nullopt : std::optional(value);
}

std::optional<int64_t> StoredRow::optionalInteger() {
  if (isNull()) {
    ++column_;
    return std::nullopt;
  }
  return integer();
}

std::optional<int> StoredRow::optionalSmallInteger() {
  if (isNull()) {
    ++column_;
    return std::nullopt;
  }
  return smallInteger();
}

std::optional<bool> StoredRow::optionalFlag() {
  const std::optional<int> value = optionalSmallInteger();
  return value ? std::optional(*value != 0) : std::nullopt;
}

std::map<std::string, double> StoredRow::measures() {
  std::map<std::string, double> measures;
  const std::string given = text();
  if (given.empty() || given == "{}") {
    return measures;
  }
  const auto failInside = [&](const char* what) {
    throw InputError(what, fmt::format("{}, {}", place(), statement_.getColumn(column_ - 1).getName()), kAsWritten);
  };
  const nlohmann::json json = nlohmann::json::parse(given, nullptr, false);
  if (!json.is_object()) {
    failInside("this is no JSON object");
  }
  for (const auto& [name, value] : json.items()) {
    if (!value.is_number()) {
      failInside("a measure of this object is no number");
    }
    measures[name] = value.get<double>();
  }
  return measures;
}

std::string trialColumns(const std::string& kind, int version) {
  std::string columns = fmt::format("trial_id, run_id, subject_id, {}, simulated, session_number", kind);
  const auto add = [&](const char* name, const auto&) {
    columns.append(firstVersionOf(name) > version ? ", NULL AS " : ", ").append(name);
  };
  const TrialRow any;
  forEachTrialColumn(any, add);
  return columns;
}

TrialRow readTrial(StoredRow& row, const ViewConditions& conditions) {
  const FieldReader reader(row, conditions);
  TrialRow trial;
  trial.trialId = row.integer();
  trial.runId = row.integer();
  trial.subject = row.text();
  trial.subjectKind = row.word(kSubjectKinds);
  trial.simulated = row.flag();
  trial.session = row.smallInteger();
  forEachTrialColumn(trial, [&](std::string_view name, auto& field) {
    if constexpr (std::is_same_v<decltype(field), int&>) {
      field = name == "plan_index" ? row.optionalSmallInteger().value_or(kNoPlan) : row.smallInteger();
    } else {
      reader.read(field);
    }
  });
  if (const auto problem = problemOf(trial)) {
    row.fail(problem->column, problem->problem);
  }
  return trial;
}

}  // namespace ocelli
