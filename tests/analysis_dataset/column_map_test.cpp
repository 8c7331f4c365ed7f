#include "analysis/dataset/column_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const fs::path kMapFolder = OCELLI_SOURCE_DIR "/analysis/dataset/column_maps";

/// With every field and every object of the schema.
Json wholeMap() {
  return Json::parse(R"({
    "base": "psychopy", "tool": "a tool", "separator": "semicolon", "decimal": "comma", "subjects": "people",
    "simulated": {"column": "bot", "is": ["1"], "optional": true},
    "rows": [{"column": "kind", "is_not": ["", "break"]}],
    "practice": {"column": "phase", "is": ["practice"]},
    "subject": {"file_name": true}, "session": "visit", "session_values": ["first", "second"],
    "task": {"value": "search"}, "block": "part", "condition": "view",
    "conditions": [{"value": "a b", "name": "ab", "label": "A and B"}, {"value": "c d"}],
    "case": "scene", "trial": null, "time": {"column": "end", "minus": "start", "unit": "ms"},
    "answer": "key", "expected": "target",
    "correct": {"column": "ok", "right": ["y"], "wrong": ["n", ""]},
    "timeout": {"column": "key", "is": [""], "limit_seconds": 20},
    "measures": {"estimate_m": "far"}
  })");
}

ColumnMap read(const Json& json) {
  return columnMapFromJsonText(json.dump(), "map.json");
}

std::string errorOf(const Json& json) {
  return analysisErrorOf([&] { read(json); });
}

/// Of the whole map with another value in a field.
std::string errorWith(const std::string& pointer, const Json& value) {
  Json json = wholeMap();
  json[Json::json_pointer(pointer)] = value;
  return errorOf(json);
}

TEST(ColumnMap, everyFieldIsRead) {
  const ColumnMap map = read(wholeMap());
  EXPECT_EQ(map.name, "map.json");
  EXPECT_EQ(map.sha256.size(), 64u);
  EXPECT_EQ(map.tool, "a tool");
  EXPECT_EQ(map.separator, ';');
  EXPECT_EQ(map.decimalPoint, ',');
  EXPECT_EQ(map.subjects, MappedSubjects::kPeople);
  EXPECT_EQ(map.simulated, (RowTest{"bot", {"1"}, {}, true}));
  ASSERT_EQ(map.rows.size(), 1u);
  EXPECT_EQ(map.rows[0], (RowTest{"kind", {}, {"", "break"}, false}));
  EXPECT_EQ(map.practice, (RowTest{"phase", {"practice"}, {}, false}));
  EXPECT_EQ(map.subject, (MappedText{.isFileName = true}));
  EXPECT_EQ(map.session, (MappedText{.column = "visit"}));
  EXPECT_EQ(map.sessionValues, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(map.task, (MappedText{.value = "search"}));
  EXPECT_EQ(map.block, (MappedText{.column = "part"}));
  ASSERT_EQ(map.conditions.size(), 2u);
  EXPECT_EQ(map.conditions[0], (MappedCondition{"a b", "ab", "A and B"}));
  EXPECT_EQ(map.conditions[1], (MappedCondition{"c d", "c_d", "c d"}));
  EXPECT_FALSE(map.trial.isSet()) << "null unsets what the base has";
  EXPECT_EQ(map.time, (MappedTime{"end", "start", 1e-3}));
  EXPECT_EQ(map.correct, (MappedCorrect{"ok", {"y"}, {"n", ""}}));
  EXPECT_EQ(map.timeout, (MappedTimeout{"key", {""}, 20.0}));
  EXPECT_EQ(map.measures, (std::map<std::string, std::string>{{"estimate_m", "far"}}));
}

TEST(ColumnMap, whatABaseSaysStaysWhereNothingElseIsSaid) {
  const ColumnMap map = read({{"base", "psychopy"}, {"condition", "camera"}});
  const ColumnMap base = readColumnMap("psychopy");
  EXPECT_EQ(map.condition.column, "camera");
  EXPECT_EQ(map.subject, base.subject);
  EXPECT_EQ(map.rows, base.rows);
  EXPECT_EQ(map.timeout, base.timeout);
  EXPECT_EQ(map.tool, "PsychoPy");
  EXPECT_EQ(map.subjects, MappedSubjects::kUnknown) << "no map that comes with the program knows who they are";
}

// The recipe of column_map.h: a file in the folder, a table of it, and its name in the list, nothing else.
TEST(ColumnMap, recipeHolds) {
  std::set<std::string> files;
  for (const auto& entry : fs::directory_iterator(kMapFolder)) {
    if (entry.is_regular_file() && entry.path().filename() != "column_map.schema.json") {
      files.insert(entry.path().stem());
    }
  }
  const std::vector<std::string> names = builtInColumnMapNames();
  EXPECT_EQ(files, std::set<std::string>(names.begin(), names.end()));
  for (const std::string& name : names) {
    EXPECT_EQ(readColumnMap(name).name, name);
    EXPECT_EQ(readColumnMap(name).sha256, readColumnMap(kMapFolder / (name + ".json")).sha256);
    EXPECT_EQ(readColumnMap(name).subjects, MappedSubjects::kUnknown) << name;
    EXPECT_TRUE(fs::exists(kMapFolder / "examples" / (name + ".csv"))) << name;
  }
}

/// The fields that the schema knows are those that the reader takes, object by object.
TEST(ColumnMap, schemaAndReaderKnowTheSameFields) {
  const Json schema = Json::parse(std::ifstream(kMapFolder / "column_map.schema.json"));
  const std::vector<std::pair<std::string, std::string>> objects{
      {"", ""},
      {"/$defs/fixed", "/task"},
      {"/$defs/test", "/simulated"},
      {"/$defs/test", "/rows/0"},
      {"/$defs/time", "/time"},
      {"/$defs/correct", "/correct"},
      {"/$defs/timeout", "/timeout"},
      {"/$defs/condition", "/conditions/0"},
  };
  for (const auto& [inSchema, inMap] : objects) {
    const std::string error = errorWith(inMap + "/no_such_field", 1);
    const size_t list = error.find("use one of: ");
    ASSERT_NE(list, std::string::npos) << inMap << error;
    std::set<std::string> fields{"$schema", "comment"};
    std::istringstream names(error.substr(list + 12));
    for (std::string name; std::getline(names >> std::ws, name, ',');) {
      fields.insert(name);
    }
    std::set<std::string> known;
    const Json& object = inSchema.empty() ? schema : schema[Json::json_pointer(inSchema)];
    for (const auto& [name, field] : object["properties"].items()) {
      known.insert(name);
    }
    EXPECT_EQ(fields, known) << inMap;
    for (const Json& required : object.value("required", Json::array())) {
      Json json = wholeMap();
      json[Json::json_pointer(inMap)].erase(required.get<std::string>());
      EXPECT_NE(errorOf(json), "") << inMap << " " << required;
    }
  }
  for (const Json& required : schema["anyOf"][1]["required"]) {  // without a base
    Json json = wholeMap();
    json.erase("base");
    EXPECT_EQ(errorOf(json), "");
    json.erase(required.get<std::string>());
    EXPECT_THAT(errorOf(json), HasSubstr("field \"" + required.get<std::string>() + "\" is missing"));
  }
  for (const auto& [field, values] : {std::pair("separator", schema["properties"]["separator"]["enum"]),
                                      {"decimal", schema["properties"]["decimal"]["enum"]},
                                      {"subjects", schema["properties"]["subjects"]["enum"]}}) {
    for (const Json& value : values) {
      Json json = wholeMap();
      json.erase("simulated");
      json[field] = value;
      EXPECT_EQ(errorOf(json), "") << field << value;
    }
    EXPECT_THAT(errorWith(std::string("/") + field, "other"), HasSubstr("must be one of"));
  }
}

TEST(ColumnMap, wrongFieldsAreNamed) {
  EXPECT_THAT(errorWith("/base", "psycho"), HasSubstr("\"base\" must be one of jspsych, psychopy, uxf"));
  EXPECT_THAT(errorWith("/subject", ""), HasSubstr("\"subject\" must have 1 to 1000 characters"));
  EXPECT_THAT(errorWith("/subject", Json::object()), HasSubstr("{\"value\": TEXT} or {\"file_name\": true}"));
  EXPECT_THAT(errorWith("/subject/value", "x"), HasSubstr("{\"value\": TEXT} or {\"file_name\": true}"));
  EXPECT_THAT(errorWith("/task", nullptr), HasSubstr("\"task\" is missing"));
  EXPECT_THAT(errorWith("/rows/0/is", Json::array({"x"})), HasSubstr("one of them"));
  EXPECT_THAT(errorWith("/rows/0/is_not", Json::array()), HasSubstr("\"rows\" 1: field \"is_not\" must be an array"));
  EXPECT_THAT(errorWith("/rows/0/is_not", Json::array({1})), HasSubstr("as they stand in the table"));
  EXPECT_THAT(errorWith("/practice/is", Json::array({"x", "x"})), HasSubstr("holds \"x\" twice"));
  EXPECT_THAT(errorWith("/time/unit", "min"), HasSubstr("\"unit\" must be one of s, ms"));
  EXPECT_THAT(errorWith("/correct/wrong", Json::array({"y"})), HasSubstr("holds \"y\", as \"right\" does"));
  EXPECT_THAT(errorWith("/timeout", Json::object()), HasSubstr("or \"limit_seconds\", or all three"));
  EXPECT_THAT(errorWith("/timeout/limit_seconds", -1), HasSubstr("must lie between"));
  EXPECT_THAT(errorWith("/conditions/1/value", "a b"), HasSubstr("as that of an earlier condition"));
  EXPECT_THAT(errorWith("/conditions/1/name", "ab"), HasSubstr("is that of the other condition too"));
  EXPECT_THAT(errorWith("/conditions/1/name", "a b"), HasSubstr("must be letters, digits"));
  EXPECT_THAT(errorWith("/conditions/1/value", "\u65e5\u672c"), HasSubstr("none can be made of"));
  EXPECT_THAT(errorWith("/subjects", "unknown"), HasSubstr("must be \"people\" where \"simulated\" tells"));
  EXPECT_THAT(errorWith("/session", nullptr), HasSubstr("\"session_values\" is of no use"));
  EXPECT_THAT(errorWith("/measures/level", 3), HasSubstr("\"level\" must be a text"));
  EXPECT_THAT(errorWith("/subject", ""), HasSubstr("see analysis/dataset/column_maps/column_map.schema.json"));
  EXPECT_THAT(analysisErrorOf([] { readColumnMap("no-such-map"); }),
              HasSubstr("one of jspsych, psychopy, uxf; or a JSON file"));
}

TEST(ColumnMap, namesOfConditionsAreMadeOfTexts) {
  EXPECT_EQ(conditionNameFrom("graph"), "graph");
  EXPECT_EQ(conditionNameFrom("two  views, wide"), "two_views_wide");
  EXPECT_EQ(conditionNameFrom("(wide)"), "wide");
  EXPECT_EQ(conditionNameFrom("???"), "");
}

}  // namespace
}  // namespace ocelli::test
