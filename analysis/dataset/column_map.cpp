#include "analysis/dataset/column_map.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "analysis/dataset/built_in_column_maps.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/sha256.h"
#include "oc_core/base/utf8.h"
#include "study/trial/view_condition.h"

namespace ocelli {
namespace {

constexpr size_t kMaxText = 1000;  // characters, of columns and their fields
constexpr size_t kMaxToolName = 100;
constexpr size_t kMaxValues = 1000;
constexpr const char* kSchema = "analysis/dataset/column_maps/column_map.schema.json";

/// null unsets what a base has set.
bool isNull(JsonFields& fields, const std::string& name) {
  return fields.value(name).is_null();
}

/// Texts, which may be empty: fields of tables are.
std::vector<std::string> readValues(JsonFields& fields, const std::string& name) {
  const nlohmann::json& list = fields.value(name);
  const auto isText = [](const nlohmann::json& each) {
    return each.is_string() && characterCount(each.get_ref<const std::string&>()) <= kMaxText;
  };
  if (!list.is_array() || list.empty() || list.size() > kMaxValues || !std::all_of(list.begin(), list.end(), isText)) {
    fields.fail(name, fmt::format("must be an array of 1 to {} texts, as they stand in the table: [\"1\", \"true\"]",
                                  kMaxValues));
  }
  auto values = list.get<std::vector<std::string>>();
  std::set<std::string> seen;
  for (const std::string& value : values) {
    if (!seen.insert(value).second) {
      fields.fail(name, fmt::format("holds \"{}\" twice", value));
    }
  }
  return values;
}

void readText(JsonFields& fields, const std::string& name, MappedText& text) {
  if (!fields.has(name)) {
    return;
  }
  text = {};
  const nlohmann::json& field = fields.value(name);
  if (field.is_object()) {
    JsonFields inner = fields.inner(name);
    text.value = inner.shortText("value", kMaxText, "");
    text.isFileName = inner.boolean("file_name", false);
    inner.rejectUnknown();
    if (text.value.empty() != text.isFileName) {
      fields.fail(name, "must say {\"value\": TEXT} or {\"file_name\": true}");
    }
  } else if (!field.is_null()) {
    text.column = fields.shortText(name, kMaxText);
  }
}

RowTest readTest(JsonFields& fields) {
  RowTest test;
  test.column = fields.shortText("column", kMaxText);
  const bool is = fields.has("is");
  if (is == fields.has("is_not")) {
    fields.fail("is", "or \"is_not\" must say which rows are meant: one of them");
  }
  (is ? test.is : test.isNot) = readValues(fields, is ? "is" : "is_not");
  test.mayBeMissing = fields.boolean("optional", false);
  return test;
}

void readTestField(JsonFields& fields, const std::string& name, RowTest& test) {
  if (!fields.has(name)) {
    return;
  }
  test = {};
  if (!isNull(fields, name)) {
    JsonFields inner = fields.inner(name);
    test = readTest(inner);
    inner.rejectUnknown();
  }
}

void readTime(JsonFields& fields, MappedTime& time) {
  if (!fields.has("time")) {
    return;
  }
  JsonFields inner = fields.inner("time");
  time.column = inner.shortText("column", kMaxText);
  time.minus = inner.shortText("minus", kMaxText, "");
  time.secondsOfUnit = inner.choice("unit", {"s", "ms"}, "s") == "ms" ? 1e-3 : 1;
  inner.rejectUnknown();
}

void readCorrect(JsonFields& fields, MappedCorrect& correct) {
  if (!fields.has("correct")) {
    return;
  }
  correct = {};
  if (isNull(fields, "correct")) {
    return;
  }
  JsonFields inner = fields.inner("correct");
  correct.column = inner.shortText("column", kMaxText);
  correct.right = readValues(inner, "right");
  correct.wrong = readValues(inner, "wrong");
  for (const std::string& value : correct.wrong) {
    if (std::find(correct.right.begin(), correct.right.end(), value) != correct.right.end()) {
      inner.fail("wrong", fmt::format("holds \"{}\", as \"right\" does", value));
    }
  }
  inner.rejectUnknown();
}

void readTimeout(JsonFields& fields, MappedTimeout& timeout) {
  if (!fields.has("timeout")) {
    return;
  }
  timeout = {};
  if (isNull(fields, "timeout")) {
    return;
  }
  constexpr double kMaxLimit = 1e6;
  JsonFields inner = fields.inner("timeout");
  timeout.column = inner.shortText("column", kMaxText, "");
  if (inner.has("limit_seconds")) {
    timeout.limitSeconds = inner.number("limit_seconds", 0.001, kMaxLimit);
  }
  const bool hasValues = inner.has("is");
  if (hasValues) {
    timeout.is = readValues(inner, "is");
  }
  inner.rejectUnknown();
  if (hasValues == timeout.column.empty() || !timeout.isSet()) {
    fields.fail("timeout", "must say \"column\" and \"is\", or \"limit_seconds\", or all three");
  }
}

void readConditions(JsonFields& fields, std::vector<MappedCondition>& conditions) {
  if (!fields.has("conditions")) {
    return;
  }
  conditions.clear();
  std::set<std::string> values;
  fields.forEach("conditions", 0, kMaxConditions, [&](JsonFields& each) {
    MappedCondition condition;
    condition.value = each.shortText("value", kMaxText);
    condition.name = each.shortText("name", kMaxText, conditionNameFrom(condition.value));
    condition.label = each.shortText("label", kMaxText, condition.value);
    if (!values.insert(condition.value).second) {
      each.fail("value", fmt::format("is \"{}\", as that of an earlier condition", condition.value));
    }
    if (condition.name.empty()) {
      each.fail("name", fmt::format("is missing: none can be made of \"{}\"", condition.value));
    }
    conditions.push_back(std::move(condition));
    ViewConditions named;
    for (const MappedCondition& known : conditions) {
      named.list.push_back({known.name, known.label});
    }
    if (const auto problem = named.problem()) {
      each.fail(problem->field, problem->what);
    }
  });
}

void readMeasures(JsonFields& fields, std::map<std::string, std::string>& measures) {
  constexpr size_t kMaxMeasures = 50;
  if (!fields.has("measures")) {
    return;
  }
  measures.clear();
  JsonFields inner = fields.inner("measures");
  const nlohmann::json& object = fields.value("measures");
  if (object.size() > kMaxMeasures) {
    fields.fail("measures", fmt::format("must be an object of at most {} columns by name", kMaxMeasures));
  }
  for (const auto& [name, column] : object.items()) {
    measures[name] = inner.shortText(name, kMaxText);
  }
}

ColumnMap mapOfBase(JsonFields& fields) {
  if (!fields.has("base")) {
    return {};
  }
  const std::string base = fields.choice("base", builtInColumnMapNames());
  return readColumnMap(base);
}

void checkComplete(const JsonFields& fields, const ColumnMap& map) {
  for (const auto& [name, isSet] : {std::pair("subject", map.subject.isSet()),
                                    {"condition", map.condition.isSet()},
                                    {"case", map.caseLabel.isSet()},
                                    {"time", !map.time.column.empty()},
                                    {"task", map.task.isSet()}}) {
    if (!isSet) {
      fields.fail(name, "is missing, and no trial can be analysed without it");
    }
  }
  if (!map.sessionValues.empty() && !map.session.isSet()) {
    fields.fail("session_values", "is of no use without \"session\"");
  }
  if (map.simulated.isSet() && map.subjects != MappedSubjects::kPeople) {
    fields.fail("subjects", fmt::format("is \"{}\", but must be \"people\" where \"simulated\" tells who is not one",
                                        nameOf(map.subjects)));
  }
}

ColumnMap readMapFields(JsonFields& fields) {
  ColumnMap map = mapOfBase(fields);
  map.tool = fields.shortText("tool", kMaxToolName, map.tool);
  if (fields.has("separator")) {
    const std::string name = fields.choice("separator", {"comma", "semicolon", "tab"});
    map.separator = name == "comma" ? ',' : name == "semicolon" ? ';' : '\t';
  }
  if (fields.has("decimal")) {
    map.decimalPoint = fields.choice("decimal", {"point", "comma"}) == "point" ? '.' : ',';
  }
  map.subjects = fields.choiceOf("subjects", kMappedSubjects, map.subjects);
  readTestField(fields, "simulated", map.simulated);
  if (fields.has("rows")) {
    map.rows.clear();
    fields.forEach("rows", 0, 20, [&](JsonFields& each) { map.rows.push_back(readTest(each)); });
  }
  readTestField(fields, "practice", map.practice);
  readText(fields, "subject", map.subject);
  readText(fields, "session", map.session);
  if (fields.has("session_values")) {
    map.sessionValues = readValues(fields, "session_values");
  }
  readText(fields, "task", map.task);
  readText(fields, "block", map.block);
  readText(fields, "condition", map.condition);
  readConditions(fields, map.conditions);
  readText(fields, "case", map.caseLabel);
  readText(fields, "trial", map.trial);
  readTime(fields, map.time);
  readText(fields, "answer", map.answer);
  readText(fields, "expected", map.expected);
  readCorrect(fields, map.correct);
  readTimeout(fields, map.timeout);
  readMeasures(fields, map.measures);
  fields.rejectUnknown();
  checkComplete(fields, map);
  return map;
}

}  // namespace

const char* nameOf(MappedSubjects subjects) {
  switch (subjects) {
    case MappedSubjects::kUnknown:
      return "unknown";
    case MappedSubjects::kPeople:
      return "people";
    case MappedSubjects::kSimulated:
      return "simulated";
  }
  return "";
}

bool RowTest::passes(const std::string& field) const {
  return is.empty() ? std::find(isNot.begin(), isNot.end(), field) == isNot.end()
                    : std::find(is.begin(), is.end(), field) != is.end();
}

std::vector<std::string> builtInColumnMapNames() {
  std::vector<std::string> names;
  for (const BuiltInColumnMap& map : builtInColumnMaps()) {
    names.push_back(map.name);
  }
  return names;
}

ColumnMap columnMapFromJsonText(const std::string& text, const std::string& name) {
  return readAs(kSchema, [&] {
    const JsonDocument document(text, name);
    JsonFields fields(document);
    ColumnMap map = readMapFields(fields);
    map.name = name;
    map.sha256 = sha256(text);
    return map;
  });
}

ColumnMap readColumnMap(const std::string& nameOrPath) {
  for (const BuiltInColumnMap& map : builtInColumnMaps()) {
    if (map.name == nameOrPath) {
      return columnMapFromJsonText(map.json, map.name);
    }
  }
  std::error_code ignored;
  if (!std::filesystem::exists(nameOrPath, ignored)) {
    throw InputError(
        "there is no such map of columns, and no such file", nameOrPath,
        fmt::format("one of {}; or a JSON file as {} says", fmt::join(builtInColumnMapNames(), ", "), kSchema));
  }
  return columnMapFromJsonText(readFile(nameOrPath, kMaxTextBytes), nameOrPath);
}

std::string conditionNameFrom(const std::string& value) {
  std::string name;
  for (const char c : value) {
    const bool isKept =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    if (isKept) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (name.ends_with('_') && !value.ends_with('_')) {
    name.pop_back();
  }
  return name;
}

}  // namespace ocelli
