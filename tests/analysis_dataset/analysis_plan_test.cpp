#include "analysis/dataset/analysis_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "oc_core/base/sha256.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::vector<std::string> kTasks{"find", "count", "path", "survey"};
const std::string kSample = OCELLI_SOURCE_DIR "/protocols/rosen2010.plan.json";

/// The sample with a contrast, which it has none of.
Json sampleJson() {
  Json json = Json::parse(std::ifstream(kSample));
  json["contrasts"] = Json::parse(R"([{"name": "views", "model": "find-time", "conditions": ["gc", "ppc"]}])");
  return json;
}

/// What the reader says of the sample with a change at a JSON pointer.
std::string errorWith(const std::string& pointer, const Json& value) {
  Json json = sampleJson();
  json[Json::json_pointer(pointer)] = value;
  return analysisErrorOf([&] { planFromJsonText(json.dump(2), "plan.json", kTasks); });
}

std::string errorOf(const std::string& text) {
  return analysisErrorOf([&] { planFromJsonText(text, "plan.json", kTasks); });
}

TEST(AnalysisPlan, sampleIsRead) {
  const AnalysisPlan plan = readPlan(kSample, kTasks);
  EXPECT_EQ(plan.name, "rosen2010");
  EXPECT_TRUE(plan.isRegistered());
  ASSERT_EQ(plan.exclusions.size(), 4u);
  EXPECT_EQ(plan.exclusions[1].what, "dropped_share");
  EXPECT_EQ(plan.exclusions[1].test, ExclusionTest::kAtLeast);
  EXPECT_EQ(plan.exclusions[1].number, 0.05);
  EXPECT_EQ(plan.exclusions[2].text, "early_frames");
  ASSERT_NE(plan.findModel("find-time"), nullptr);
  EXPECT_EQ(plan.findModel("find-time")->randomEffects[0].slopes, std::vector<std::string>{"view"});
  EXPECT_EQ(plan.seed, 2010u);
  EXPECT_EQ(plan.sha256.size(), 64u);
  EXPECT_THAT(describe(plan), HasSubstr(plan.sha256));
}

TEST(AnalysisPlan, hashIsThatOfTheFile) {
  const std::string text = "{\"name\": \"a\"}";
  EXPECT_EQ(planFromJsonText(text, "plan.json", kTasks).sha256, sha256(text));
  EXPECT_EQ(sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");  // FIPS 180-4
}

TEST(AnalysisPlan, unknownFieldsAreNamedWithTheirLine) {
  EXPECT_THAT(errorOf("{\n  \"name\": \"a\",\n  // why not\n  \"alhpa\": 0.05\n}"),
              HasSubstr("plan.json:4: field \"alhpa\" is unknown"));
  EXPECT_THAT(errorOf("{\"name\": \"a\",\n \"models\": [\n {\"name\": \"b\",\n \"task\": \"find\", \"kind\": "
                      "\"cox\",\n\"termz\": []}]}"),
              HasSubstr("plan.json:5, \"models\" 1: field \"termz\" is unknown"));
  EXPECT_THAT(errorOf(std::string("{// one\r\"name\": \"a\", /* two\n */ // three\0\n\"alhpa\": 1}", 53)),
              HasSubstr("plan.json:3: field \"alhpa\" is unknown"));
  EXPECT_THAT(errorOf("{\"name\": \"a\", \"name\": \"b\"}"), HasSubstr("stands twice"));
  EXPECT_THAT(errorOf("{\"name\": \"a\"\n \"alpha\": 1}"), HasSubstr("plan.json:2:8: this is not valid JSON"));
  EXPECT_THAT(errorOf(std::string(500, '[')), HasSubstr("nested deeper than 100 levels"));
  EXPECT_THAT(errorOf("[]"), HasSubstr("a JSON object { ... } is expected"));
  EXPECT_THAT(errorOf("{\"name\": \"a\", \"alpha\": 1e999}"), HasSubstr("too large"));
}

TEST(AnalysisPlan, contradictionsAreRefused) {
  EXPECT_EQ(errorWith("/alpha", 0.01), "");
  const struct {
    const char* pointer;
    Json value;
    const char* says;
  } wrong[] = {
      {"/alpha", 0.7, "field \"alpha\" must lie between 1e-06 and 0.5, not 0.7"},
      {"/seed", -1, "field \"seed\" must lie between 0 and 2147483647, not -1"},
      {"/seed", 1.5, "field \"seed\" must be a whole number"},
      {"/bootstrap_samples", 18446744073709551615ull, "must lie between 100 and 1000000, not 18446744073709551615"},
      {"/protocol_sha256", "abc", "must be 64 digits"},
      {"/forced_sessions", "kept", "field \"forced_sessions\" must be one of excluded, analysed, not \"kept\""},
      {"/find_timeouts", "gone", "must be one of censored, removed, set_to_limit, not \"gone\""},
      {"/models/0/kind", "anova", "must be one of linear_mixed"},
      {"/models/0/task", "walk", "must be one of find, count, path, survey, not \"walk\""},
      {"/models/0/kind", "linear_mixed", "knows no censored times, but \"find_timeouts\" is censored"},
      {"/models/0/random/1/slopes", {"objects"}, "holds \"objects\", which is not a term of the model"},
      {"/models/0/terms", {"view", "colour"}, "holds \"colour\""},
      {"/models/0/terms", {"view:"}, "holds \"view:\""},
      {"/models/0/terms", {"view:view"}, "holds \"view:view\""},
      {"/models/0/terms", {"view", "view"}, "holds \"view\" twice"},
      {"/models/0/terms", Json::array(), "is missing, and a mixed model needs it"},
      {"/models/1/name", "find-time", "is \"find-time\", as that of another"},
      {"/models/0/random/0/group", "case", "is \"case\" a second time"},
      {"/hypotheses/0/model", "none", "is \"none\", which \"models\" does not hold"},
      {"/hypotheses/0/term", "exposure", "is \"exposure\", but model \"find-time\" has the terms"},
      {"/families/0/hypotheses", {"find-faster", "count-better"}, "does not hold hypothesis \"path-alike\""},
      {"/families/0/hypotheses", {"find-slower"}, "names \"find-slower\""},
      {"/families/1/hypotheses/0", "find-faster", "which stands in a family already"},
      {"/families/0/correction", "bonferroni", "must be one of holm, none, not \"bonferroni\""},
      {"/equivalence", Json::array(), "has no bounds for task \"path\""},
      {"/equivalence/0/lower", 0.05, "must lie below 0"},
      {"/exclusions/0/what", "mood", "is \"mood\", but must be one of: subject"},
      {"/exclusions/0/value", 3, "which takes no \"test\" and no \"value\""},
      {"/exclusions/1/value", 1.5, "a number from 0 to 1"},
      {"/exclusions/1/value", "many", "needs the \"test\" at_least or at_most"},
      {"/exclusions/1/test", "is", "needs the \"test\" at_least or at_most"},
      {"/exclusions/2/value", "late", "must be one of: good, dropped_frames"},
      {"/exclusions/2/test", "roughly", "needs the \"test\" is or is_not"},
  };
  for (const auto& each : wrong) {
    EXPECT_THAT(errorWith(each.pointer, each.value), HasSubstr(each.says)) << each.pointer << " " << each.value;
  }
}

TEST(AnalysisPlan, tasksAreThoseOfTheStudy) {
  Json json = sampleJson();
  json["models"][10]["task"] = "nearer";
  const std::string text = json.dump();
  EXPECT_THAT(errorOf(text), HasSubstr("must be one of find, count, path, survey, not \"nearer\""));
  std::vector<std::string> tasks = kTasks;
  tasks.push_back("nearer");
  EXPECT_EQ(planFromJsonText(text, "plan.json", tasks).models[10].task, "nearer");
}

/// A linear model counts time-outs as they are: a plan that says so may test by it, and any plan may fit it beside
/// others.
TEST(AnalysisPlan, linearModelsTestWhatTheyCan) {
  for (const char* timeouts : {"set_to_limit", "removed"}) {
    Json json = sampleJson();
    json["models"][0]["kind"] = "linear_mixed";
    json["find_timeouts"] = timeouts;
    EXPECT_EQ(errorOf(json.dump()), "") << timeouts;
  }
  Json json = sampleJson();
  Json beside = json["models"][0];
  beside["name"] = "find-linear";
  beside["kind"] = "linear_mixed";
  json["models"].push_back(beside);
  EXPECT_EQ(errorOf(json.dump()), "");
  // As in a plan that does not say.
  json["models"][0]["kind"] = "linear_mixed";
  json.erase("find_timeouts");
  EXPECT_THAT(errorOf(json.dump()), HasSubstr("give the model the kind log_normal_mixed, or set \"find_timeouts\""));
}

TEST(AnalysisPlan, namesContrasts) {
  const auto planOf = [](const std::string& contrast, const std::string& term = "condition") {
    return R"({"name": "p", "factors": ["camera", "height"],
      "models": [{"name": "time", "task": "find", "kind": "log_normal_mixed", "terms": [")" +
           term + R"("],
                  "random": [{"group": "subject", "slopes": ["camera"]}]},
                 {"name": "curve", "task": "find", "kind": "kaplan_meier"}],
      "contrasts": [{"name": "first", "model": "time", "conditions": ["a", "b"]}, )" +
           contrast + "]}";
  };
  const AnalysisPlan plan = planFromJsonText(
      planOf(
          R"({"name": "c", "model": "time", "family": "f", "factors": {"camera": ["bent", "flat"], "height": ["x", "y"]}},
                {"name": "w", "model": "time", "statement": "So it is", "weights": {"a": 1, "b": -0.5, "c": -0.5}})"),
      "plan.json", kTasks);
  EXPECT_THAT(plan.models[0].terms, ElementsAre("view")) << "another word for it";
  ASSERT_EQ(plan.contrasts.size(), 3u);
  EXPECT_EQ(plan.contrasts[0].family, "time");
  EXPECT_EQ(plan.contrasts[0].weights, (std::vector<std::pair<std::string, double>>{{"a", 1}, {"b", -1}}));
  ASSERT_EQ(plan.contrasts[1].levels.size(), 2u);
  EXPECT_EQ(plan.contrasts[1].levels[0].first, "bent");
  EXPECT_EQ(plan.contrasts[2].weights.size(), 3u);
  const auto error = [&](const std::string& contrast) { return errorOf(planOf(contrast)); };
  EXPECT_THAT(error(R"({"name": "first", "model": "time", "conditions": ["a", "c"]})"),
              HasSubstr("as that of another"));
  EXPECT_THAT(error(R"({"name": "c", "model": "none", "conditions": ["a", "c"]})"), HasSubstr("no mixed model"));
  EXPECT_THAT(error(R"({"name": "c", "model": "curve", "conditions": ["a", "c"]})"), HasSubstr("no mixed model"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time"})"), HasSubstr("must say what is compared"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "conditions": ["a", "b"], "weights": {"a": 1, "b": -1}})"),
              HasSubstr("must say what is compared"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "conditions": ["a", "a"]})"), HasSubstr("two different"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "weights": {"a": 1, "b": -0.5}})"),
              HasSubstr("their sum is 0.5"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "weights": {"a": 0, "b": 0}})"), HasSubstr("not all be 0"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "factors": {"camera": ["bent"]}})"),
              HasSubstr("two different levels"));
  EXPECT_THAT(error(R"({"name": "c", "model": "time", "factors": {"lens": ["a", "b"]}})"),
              HasSubstr("but the field \"factors\" of the plan has: camera, height"));
  EXPECT_THAT(errorOf(planOf(R"({"name": "c", "model": "time", "conditions": ["a", "c"]})", "lens")),
              HasSubstr("objects, trial, camera, height, joined by"));
}

/// The fields that the schema knows are those that the reader takes, object by object.
TEST(AnalysisPlan, schemaAndReaderKnowTheSameFields) {
  const Json schema = Json::parse(std::ifstream(OCELLI_SOURCE_DIR "/protocols/analysis_plan.schema.json"));
  const std::vector<std::pair<std::string, std::string>> objects{
      {"", ""},
      {"/$defs/exclusion", "/exclusions/0"},
      {"/$defs/model", "/models/0"},
      {"/$defs/random", "/models/0/random/0"},
      {"/$defs/hypothesis", "/hypotheses/0"},
      {"/$defs/contrast", "/contrasts/0"},
      {"/$defs/family", "/families/0"},
      {"/$defs/bounds", "/equivalence/0"},
  };
  for (const auto& [inSchema, inPlan] : objects) {
    const std::string error = errorWith(inPlan + "/no_such_field", 1);
    const size_t list = error.find("use one of: ");
    ASSERT_NE(list, std::string::npos) << inPlan << error;
    std::set<std::string> read{"$schema", "comment"};
    std::istringstream names(error.substr(list + 12));
    for (std::string name; std::getline(names >> std::ws, name, ',');) {
      read.insert(name);
    }
    std::set<std::string> known;
    const Json& object = inSchema.empty() ? schema : schema[Json::json_pointer(inSchema)];
    for (const auto& [name, field] : object["properties"].items()) {
      known.insert(name);
    }
    EXPECT_EQ(read, known) << inPlan;
    for (const Json& required : object.value("required", Json::array())) {
      Json json = sampleJson();
      Json& owner = inPlan.empty() ? json : json[Json::json_pointer(inPlan)];
      owner.erase(required.get<std::string>());
      EXPECT_NE(errorOf(json.dump()), "") << inPlan << " " << required;
    }
  }
}

}  // namespace
}  // namespace ocelli::test
