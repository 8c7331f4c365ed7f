// protocols/protocol.schema.json says what the reader does: names, choices, ranges, what is required.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "study/outline/question_kinds.h"
#include "study/outline/questionnaire.h"
#include "study/protocol/staircase.h"
#include "study/tasks/task_registry.h"
#include "study/views/view_registry.h"
#include "tests/base/schema_agreement.h"
#include "tests/study_protocol/protocol_text.h"

namespace ocelli::test {
namespace {

using Json = nlohmann::json;

const Json& schema() {
  static const Json json = Json::parse(std::ifstream(OCELLI_SOURCE_DIR "/protocols/protocol.schema.json"));
  return json;
}

/// What the general walk cannot test: it then tests the name alone, and that a number is refused.
bool isOwnKind(const Json& property) {
  return property.contains("pattern") || property.value("type", Json()) == "object" ||
         property.value("type", Json()).is_array();
}

/// The small protocol with one of its blocks alone, in all sessions, on the smallest screen: quick to read, as the
/// reader draws what cases show.
Json withBlock(size_t index) {
  Json json = smallProtocol();
  json.at("screen").update({{"least_width", 640}, {"least_height", 480}});
  json["blocks"] = Json::array({json.at("blocks").at(index)});
  json.at("blocks").at(0)["sessions"] = {1, 2};
  return json;
}

/// Compares one object of the schema with what the reader takes at `pointer` of `document`. `own` names what the
/// general walk cannot test.
void expectAgreement(const Json& description, const Json& document, const std::string& pointer,
                     const std::vector<std::string>& own = {}) {
  SCOPED_TRACE(pointer + " of " + document.at("blocks").at(0).at("name").get<std::string>());
  const Json::json_pointer at(pointer);
  SchemaAgreement agreement;
  agreement.schema = description;
  for (auto& [name, property] : agreement.schema.at("properties").items()) {
    if (std::find(own.begin(), own.end(), name) != own.end() || isOwnKind(property)) {
      property = Json::object();
    } else if (property.value("type", Json()) == "boolean") {
      property = {{"enum", {true, false}}};
    } else if (name == "row" || name == "column") {
      property["maximum"] = 2;  // of the maze
    }
  }
  agreement.base = pointer.empty() ? document : document.at(at);
  agreement.errorOf = [&](const std::string& text) {
    Json json = document;
    (pointer.empty() ? json : json.at(at)) = Json::parse(text);
    return protocolError(json);
  };
  agreement.check();
}

const Json& def(const char* name) {
  return schema().at("$defs").at(name);
}

/// A block with the fields of its task.
Json blockOf(const std::string& task) {
  Json merged = def("block");
  merged.at("properties").update(def(task.c_str()).at("properties"));
  for (const Json& name : def(task.c_str()).at("required")) {
    merged.at("required").push_back(name);
  }
  merged["additionalProperties"] = false;  // as "unevaluatedProperties" of blocks has it
  return merged;
}

TEST(ProtocolSchema, AgreesWithTheReaderOfPagesFormsAndLimits) {
  const Json document = withBlock(0);
  Json everySession = document;
  everySession.at("blocks").at(0).erase("sessions");
  expectAgreement(schema(), everySession, "", {"conditions", "factors", "before", "after"});
  expectAgreement(def("page"), document, "/consent");
  expectAgreement(def("page"), document, "/blocks/0/instructions/0");
  expectAgreement(def("example"), document, "/blocks/0/instructions/0/picture", {"condition", "case"});  // names
  expectAgreement(def("form"), document, "/demographics");
  expectAgreement(def("screen"), document, "/screen");
  expectAgreement(def("timing"), document, "/timing");
  expectAgreement(def("exclusion"), document, "/exclusions/0", {"test"});
  Json maze = def("maze");
  maze.at("properties")["landmarks"] = Json::object();  // which the reader knows, to refuse it with a reason
  expectAgreement(maze, document, "/mazes/ring", {"plan"});
  expectAgreement(def("controls"), document, "/controls",
                  {"forward", "backward", "left", "right", "turn_left", "turn_right", "select"});
}

/// The schema names the fields of all kinds of questions together.
TEST(ProtocolSchema, AgreesWithTheReaderOfQuestions) {
  std::set<std::string> kinds;
  for (const QuestionKind& kind : questionKinds()) {
    kinds.insert(kind.name);
  }
  EXPECT_EQ(def("form_field").at("properties").at("kind").at("enum").get<std::set<std::string>>(), kinds);
  struct KindFields {
    std::string kind;
    std::string json;
    std::vector<std::string> names;
  };
  std::set<std::string> described{"$schema", "comment", "name", "question", "kind", "required"};
  for (const KindFields& fields : std::vector<KindFields>{
           {"choice",
            R"({"options": ["a", "b"], "values": ["x", "y"], "ends": ["p", "q"], "favors": ["ppc", "gc"]})",
            {"options", "values", "ends", "favors"}},
           {"multiple", R"({"options": ["a", "b"], "values": ["x", "y"]})", {"options", "values"}},
           {"text", "{}", {"max_characters"}},
           {"number", R"({"least": 5})", {"least", "most", "step", "unit"}},
           {"slider",
            R"({"ends": ["p", "q"], "least": 0, "most": 0.7, "step": 0.35})",
            {"least", "most", "step", "ends"}},
           {"matrix",
            R"({"options": ["a", "b"], "values": ["x", "y"], "ends": ["p", "q"],
                          "rows": [{"name": "r", "label": "R"}]})",
            {"options", "values", "ends", "rows"}}}) {
    SCOPED_TRACE(fields.kind);
    Json description = def("form_field");
    const Json all = description.at("properties");
    Json& properties = description.at("properties");
    for (const auto& [name, property] : all.items()) {
      const bool isOwn = std::find(fields.names.begin(), fields.names.end(), name) != fields.names.end();
      if (!described.contains(name) && !isOwn) {
        properties.erase(name);
      }
    }
    properties["favors"] = Json::object();  // which the reader of all kinds knows, to refuse it with a reason
    Json document = withBlock(0);
    Json field = Json::parse(fields.json);
    field.update({{"name", "q"}, {"question", "Which?"}, {"kind", fields.kind}});
    document.at("survey").at("fields").at(0) = field;
    document.at("survey").at("fields").erase(document.at("survey").at("fields").begin() + 1,
                                             document.at("survey").at("fields").end());
    document.erase("exclusions");
    // What depends on other fields of the question: numbers from 5 on take no 1 as the highest, and a line of 0.7 in
    // steps of 0.35 takes a 1 nowhere.
    std::vector<std::string> own{"kind", "favors", "values", "most"};
    if (fields.kind == "slider") {
      own.insert(own.end(), {"least", "step"});
    }
    expectAgreement(description, document, "/survey/fields/0", own);
  }
  const Json document = [] {
    Json json = withBlock(0);
    json["after"] = Json::parse(R"([{"name": "own", "title": "T", "fields": [{"name": "a", "question": "?",
        "kind": "matrix", "options": ["x", "y"], "rows": [{"name": "r", "label": "R"}]}]}])");
    json.at("blocks").at(0)["after"] = json["after"];
    return json;
  }();
  expectAgreement(def("form_field").at("properties").at("rows").at("items"), document, "/after/0/fields/0/rows/0",
                  {"name"});
  EXPECT_EQ(def("listed_form").at("properties").at("questionnaire").at("enum").get<std::vector<std::string>>(),
            questionnaireNames());
  std::vector<std::string> languages;
  for (const SubjectCatalogue& each : subjectCatalogues()) {
    languages.push_back(each.language);
  }
  EXPECT_EQ(schema().at("properties").at("language").at("enum").get<std::vector<std::string>>(), languages);
}

TEST(ProtocolSchema, AgreesWithTheReaderOfConditions) {
  Json document = withBlock(0);
  document.at("blocks").at(0).erase("sessions");
  document["conditions"] =
      Json::parse(R"([{"name": "ppc", "label": "a", "view": "pinhole"}, {"name": "gc", "view": "graph"}])");
  expectAgreement(def("condition"), document, "/conditions/0", {"view", "name"});
  std::set<std::string> kinds;
  for (const ViewKind& kind : viewKinds()) {
    kinds.insert(kind.name);
  }
  document["factors"] = Json::parse(R"([{"name": "size", "levels": ["small", "large"], "of": "cases"}])");
  for (Json& each : document.at("blocks").at(0).at("cases")) {
    each["factors"] = Json::parse(R"({"size": "small"})");
  }
  expectAgreement(def("factor"), document, "/factors/0", {"name", "levels", "of"});
  EXPECT_EQ(def("factor").at("properties").at("levels").at("maxItems"), 16);
  EXPECT_EQ(schema().at("properties").at("conditions").at("maxItems"), kMaxConditions);
  EXPECT_EQ(def("view_kind").at("enum").get<std::set<std::string>>(), kinds);
  // The schema names the options of all kinds together.
  struct KindOptions {
    std::string kind;
    std::string json;  ///< of a view
    std::vector<std::string> required;
    std::vector<std::string> others;
  };
  for (const KindOptions& options : std::vector<KindOptions>{
           {"pinhole", "{}", {}, {"variant"}},
           {"graph", "{}", {}, {"variant"}},
           {"panes", R"({"headings_degrees": [0]})", {"headings_degrees"}, {"fov_horizontal_degrees"}},
           {"ocri",
            R"({"camera": "ddoc", "eye_offset_meters": [0, 0, 0]})",
            {"camera", "eye_offset_meters"},
            {"image_scale"}},
           {"camera", R"({"camera": "ddoc"})", {"camera"}, {}},
           {"display",
            R"({"distance_meters": 100, "radius_meters": 0.01})",
            {},
            {"camera", "profile", "distance_meters", "radius_meters", "head", "made_at", "mean_luminance",
             "image_rows"}}}) {
    Json description = def("view");
    Json properties{{"$schema", Json::object()}, {"comment", Json::object()}, {"kind", Json::object()}};
    for (const std::vector<std::string>* names : {&options.required, &options.others}) {
      for (const std::string& name : *names) {
        properties[name] = description.at("properties").at(name);
      }
    }
    description["properties"] = properties;
    description["required"] = options.required;
    Json view = Json::parse(options.json);
    view["kind"] = options.kind;
    document.at("conditions").at(1)["view"] = view;
    expectAgreement(description, document, "/conditions/1/view",
                    {"kind", "camera", "eye_offset_meters", "headings_degrees", "profile", "head", "made_at", "$schema",
                     "comment"});
  }
}

// Fields whose choices depend on other parts of the protocol.
const std::vector<std::string> kOwnOfBlocks{"maze", "task", "sessions", "after"};

TEST(ProtocolSchema, AgreesWithTheReaderOfFind) {
  Json document = withBlock(0);
  const Json block = blockOf("find");
  expectAgreement(block, document, "/blocks/0", kOwnOfBlocks);
  expectAgreement(block.at("properties").at("object"), document, "/blocks/0/object");
  expectAgreement(block.at("properties").at("start"), document, "/blocks/0/start");
  expectAgreement(def("find_case"), document, "/blocks/0/cases/0", {"distance_band"});  // in place of row and column
  Json drawn = document;
  drawn["mazes"]["ring"]["plan"] = {"+-+-+-+", "|     |", "+-+ + +", "|   | |", "+ +-+ +", "|     |", "+-+ +-+"};
  drawn["blocks"][0]["cases"] = {{{"distance_band", 1}}};
  const Json::json_pointer at("/blocks/0/cases/0/distance_band");
  EXPECT_EQ(protocolError(drawn), "");
  for (const Json& number : {Json(0), Json(5), Json(1.5), Json("1")}) {
    drawn.at(at) = number;
    EXPECT_NE(protocolError(drawn).find("field \"distance_band\""), std::string::npos) << protocolError(drawn);
  }
  expectAgreement(def("moving"), document, "/blocks/0/moving");
  document.at("blocks").at(0).at("practice")["most_trials"] = 100;
  expectAgreement(block.at("properties").at("practice"), document, "/blocks/0/practice");
}

TEST(ProtocolSchema, AgreesWithTheReaderOfCount) {
  Json document = withBlock(1);
  expectAgreement(def("count_case"), document, "/blocks/0/cases/0", {"objects"});
  expectAgreement(def("comprehensive"), document, "/blocks/0/comprehensive");
  expectAgreement(def("pinholes"), document, "/blocks/0/pinholes");
  expectAgreement(def("count_variant"), document, "/blocks/0/variants/low");
  Json pinhole = def("pinhole");
  pinhole.at("properties").at("heading") = pinhole.at("properties").at("heading").at("anyOf").at(1);
  expectAgreement(pinhole, document, "/blocks/0/pinholes/views/0", {"east", "south"});
  const Json block = blockOf("count");
  expectAgreement(block.at("properties").at("places").at("items"), document, "/blocks/0/places/0");
  document.at("blocks").at(0)["least_answer"] = 0;
  expectAgreement(block, document, "/blocks/0", kOwnOfBlocks);
}

TEST(ProtocolSchema, AgreesWithTheReaderOfPath) {
  Json document = withBlock(2);
  expectAgreement(def("path_case"), document, "/blocks/0/cases/0");
  document.at("blocks").at(0)["least_seconds"] = 1;
  expectAgreement(blockOf("path"), document, "/blocks/0", kOwnOfBlocks);
}

TEST(ProtocolSchema, AgreesWithTheReaderOfNearer) {
  Json document = withBlock(2);
  document.at("mazes")["hall"] = Json::parse(R"({"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]})");
  document.at("blocks").at(0) = Json::parse(R"({"name": "nearer", "title": "Nearer", "task": "nearer", "maze": "hall",
      "object": {"shape": "cone"}, "start": {"row": 0, "column": 0, "heading": "east"}, "sessions": [1, 2],
      "instructions": [{"title": "Nearer", "paragraphs": ["Which?"]}], "practice": {},
      "practice_cases": [{"left": {"row": 0, "column": 2, "south": -0.2}, "right": {"row": 0, "column": 3, "south": 0.2}}],
      "example_cases": [{"left": {"row": 0, "column": 2, "south": -0.2}, "right": {"row": 0, "column": 3, "south": 0.2}}],
      "cases": [{"left": {"row": 0, "column": 2, "south": -0.2}, "right": {"row": 0, "column": 3, "south": 0.2}}]})");
  // What decides whether a case can be seen.
  std::vector<std::string> own = kOwnOfBlocks;
  own.emplace_back("fov_horizontal_degrees");
  expectAgreement(blockOf("nearer"), document, "/blocks/0", own);
  expectAgreement(def("nearer_case"), document, "/blocks/0/cases/0");
  // Other places of an object are out of sight, so that ranges cannot be tried; they are those of a place to find.
  Json place = def("find_case").at("properties");
  place.erase("label");
  place.erase("distance_band");
  place.erase("factors");
  place.erase("level");
  EXPECT_EQ(def("nearer_object").at("properties"), place);
  document["blocks"][0]["cases"][0]["left"]["north"] = 0.1;
  EXPECT_NE(protocolError(document).find("field \"north\" is unknown"), std::string::npos) << protocolError(document);
}

TEST(ProtocolSchema, AgreesWithTheReaderOfEstimates) {
  for (const char* task : {"distance", "direction"}) {
    Json document = withBlock(2);
    document.at("mazes")["hall"] = Json::parse(R"({"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]})");
    document.at("blocks").at(0) =
        Json::parse(R"({"name": "estimate", "title": "Estimate", "maze": "hall", "object": {"shape": "cone"},
        "start": {"row": 0, "column": 0, "heading": "east"}, "sessions": [1, 2],
        "instructions": [{"title": "Estimate", "paragraphs": ["Where?"]}], "practice": {},
        "practice_cases": [{"row": 0, "column": 3}], "example_cases": [{"row": 0, "column": 3}],
        "cases": [{"row": 0, "column": 2}]})");
    document.at("blocks").at(0)["task"] = task;
    // What decides whether a case can be seen, and told.
    std::vector<std::string> own = kOwnOfBlocks;
    own.insert(own.end(), {"fov_horizontal_degrees", "scale_meters"});
    expectAgreement(blockOf(task), document, "/blocks/0", own);
    // Other places are out of sight, so that ranges cannot be tried: cases are those of places to find.
    Json places = def("find_case").at("properties");
    places.erase("distance_band");
    EXPECT_EQ(def("estimate_case").at("properties"), places);
    document["blocks"][0]["cases"][0]["north"] = 0.1;
    EXPECT_NE(protocolError(document).find("use one of: column, east, factors, label, level, row, south"),
              std::string::npos)
        << protocolError(document);
    document["blocks"][0]["cases"][0].erase("north");
    for (const auto& [meters, isRight] : std::vector<std::pair<double, bool>>{{0.9, false}, {7, true}, {1001, false}}) {
      if (def(task).at("properties").contains("scale_meters")) {
        document.at("blocks").at(0)["scale_meters"] = meters;
        document.at("blocks").at(0).at("practice_cases").at(0)["column"] = 2;
        document.at("blocks").at(0).at("example_cases").at(0)["column"] = 2;
        EXPECT_EQ(protocolError(document).empty(), isRight) << protocolError(document);
      }
    }
  }
}

TEST(ProtocolSchema, AgreesWithTheReaderOfStaircases) {
  EXPECT_EQ(def("level").at("minimum"), 1e-6);
  EXPECT_EQ(def("level").at("maximum"), 1e6);
  std::set<std::string> methods;
  for (const StaircaseMethod& method : staircaseMethods()) {
    methods.insert(method.name);
  }
  EXPECT_EQ(def("staircase").at("properties").at("method").at("enum").get<std::set<std::string>>(), methods);
  // The schema names the fields of all methods together.
  const std::map<std::string, std::vector<std::string>> others{
      {"quest_plus", {"right_in_a_row", "first_step"}},
      {"up_down", {"function", "least_slope", "most_slope", "most_lapses"}}};
  for (const auto& [method, notOfIt] : others) {
    Json document = withBlock(0);
    Json& block = document.at("blocks").at(0);
    block["staircase"] = {{"method", method}};
    block.at("cases").at(0)["level"] = 1;
    block.at("cases").at(1)["level"] = 2;
    Json description = def("staircase");
    for (const std::string& name : notOfIt) {
      description.at("properties").erase(name);
    }
    block.at("staircase")["guess_rate"] = 0.5;  // which this task does not say
    if (method == "quest_plus") {
      block.at("staircase").update({{"least_slope", 0.05}, {"most_slope", 50}});  // each is tried against the other
    }
    expectAgreement(description, document, "/blocks/0/staircase", {"method"});
  }
}

Json frontDocument() {
  Json document = withBlock(2);
  document.at("mazes")["hall"] = Json::parse(R"({"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]})");
  const std::string cases = R"([{"left": {"ahead_meters": 5, "right_meters": -0.25, "shape": "cube", "color": "green"},
                                 "right": {"ahead_meters": 6.2, "right_meters": 0.25, "up_meters": 0.01}}])";
  document.at("blocks").at(0) = Json::parse(
      R"({"name": "front", "title": "Front", "task": "frontmost", "maze": "hall", "object": {"shape": "cone"},
          "start": {"row": 0, "column": 0, "heading": "east"}, "sessions": [1, 2],
          "instructions": [{"title": "Front", "paragraphs": ["Which?"]}], "practice": {}, "practice_cases": )" +
      cases + R"(, "example_cases": )" + cases + R"(, "cases": )" + cases + "}");
  return document;
}

TEST(ProtocolSchema, AgreesWithTheReaderOfFront) {
  Json document = frontDocument();
  // What decides whether a case can be seen.
  std::vector<std::string> own = kOwnOfBlocks;
  own.emplace_back("fov_horizontal_degrees");
  own.emplace_back("object");
  expectAgreement(blockOf("frontmost"), document, "/blocks/0", own);
  expectAgreement(def("frontmost_case"), document, "/blocks/0/cases/0");
  // Other places of an object cannot be shown, so that ranges cannot be tried.
  Json properties = def("frontmost_object").at("properties");
  std::set<std::string> names;
  for (const auto& [name, property] : properties.items()) {
    names.insert(name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"$schema", "ahead_meters", "color", "comment", "right_meters", "shape",
                                          "up_meters"}));
  EXPECT_EQ(properties.at("shape").at("enum"),
            blockOf("count").at("properties").at("object").at("properties").at("shape").at("enum"));
  EXPECT_EQ(properties.at("color").at("enum"),
            blockOf("find").at("properties").at("object").at("properties").at("color").at("enum"));
  document["blocks"][0]["cases"][0]["left"]["left_meters"] = 0.1;
  EXPECT_NE(protocolError(document).find("field \"left_meters\" is unknown"), std::string::npos)
      << protocolError(document);
}

TEST(ProtocolSchema, AgreesWithTheReaderOfHeads) {
  Json document = frontDocument();
  document.erase("survey");
  document["conditions"] = Json::parse(
      R"([{"name": "rest", "view": {"kind": "display", "distance_meters": 6, "radius_meters": 2}},
          {"name": "sway", "view": {"kind": "display", "distance_meters": 6, "radius_meters": 2,
           "head": {"sway_degrees": 5}}}])");
  Json description = def("head");
  description["required"] = {"sway_degrees"};
  expectAgreement(description, document, "/conditions/1/view/head", {"images", "poses", "$schema", "comment"});
  document["conditions"][1]["view"]["head"] =
      Json::parse(R"({"images": 240, "poses": [{"time": 0, "eye": [0, 0, 3]}, {"time": 1, "eye": [1, 0, 3]}]})");
  EXPECT_EQ(protocolError(document), "");
  // An eye that moves goes with tasks in which all stands still.
  Json other = withBlock(2);
  other.erase("survey");
  other["conditions"] = document["conditions"];
  EXPECT_NE(protocolError(other).find("condition \"sway\" has a \"head\" that moves"), std::string::npos)
      << protocolError(other);
}

TEST(ProtocolSchema, KnowsEveryTask) {
  Json names = Json::array();
  for (const TaskKind& kind : taskKinds()) {
    names.push_back(kind.name);
    EXPECT_TRUE(schema().at("$defs").contains(kind.name)) << kind.name;
  }
  EXPECT_EQ(def("block").at("properties").at("task").at("enum"), names);
}

}  // namespace
}  // namespace ocelli::test
