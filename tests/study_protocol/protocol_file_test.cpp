#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "oc_core/base/error.h"
#include "oc_core/base/sha256.h"
#include "study/outline/condition_names.h"
#include "study/protocol/protocol.h"
#include "tests/base/temporary_folder.h"
#include "tests/study_protocol/protocol_text.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Json = nlohmann::json;

TEST(ProtocolFile, IsReadAsItStands) {
  const Protocol protocol = protocolFromJsonText(smallProtocol().dump(), "study.json");
  EXPECT_EQ(protocol.name, "small");
  EXPECT_EQ(protocol.sessions, 2);
  EXPECT_EQ(protocol.minutesBetweenSessions, 10);
  EXPECT_EQ(protocol.seed, 5u);
  ASSERT_TRUE(protocol.consent.has_value());
  EXPECT_EQ(protocol.consent->title, "Consent");
  ASSERT_TRUE(protocol.demographics.has_value());
  EXPECT_EQ(protocol.demographics->name, "demographics");
  EXPECT_THAT(protocol.demographics->fields[0].options, ElementsAre("normal", "impaired"));
  ASSERT_TRUE(protocol.survey.has_value());
  EXPECT_THAT(protocol.survey->fields[0].ends, ElementsAre("this", "that"));
  EXPECT_THAT(protocol.survey->fields[0].favors, ElementsAre(TrialView::kOther, TrialView::kReference));
  EXPECT_TRUE(protocol.demographics->fields[0].favors.empty());
  EXPECT_EQ(protocol.welcome[0].image, "controls");
  ASSERT_EQ(protocol.blocks.size(), 3u);
  EXPECT_EQ(protocol.blocks[0].name, "find it");
  EXPECT_EQ(protocol.blocks[0].taskName, "find");
  EXPECT_EQ(protocol.blocks[0].task->caseCount(), 2);
  EXPECT_EQ(protocol.blocks[0].task->caseInfo(1).label, "there");
  EXPECT_THAT(protocol.blocks[0].sessions, ElementsAre(1));
  EXPECT_EQ(protocol.blocks[0].order, TrialOrder::kBalanced);
  EXPECT_EQ(protocol.blocks[0].views, ViewsOfCases::kAll);
  ASSERT_TRUE(protocol.blocks[0].practice.has_value());
  EXPECT_EQ(protocol.blocks[0].practice->maxTrials, 2);
  EXPECT_EQ(protocol.blocks[0].practice->task->caseCount(), 1);
  EXPECT_EQ(protocol.blocks[1].order, TrialOrder::kAlternating);
  EXPECT_EQ(protocol.blocks[1].views, ViewsOfCases::kOne);
  EXPECT_EQ(protocol.screen.refreshHertz, 60);
  EXPECT_EQ(protocol.resume, ResumePolicy::kNextTrial);
  EXPECT_EQ(protocol.exclusions[0].text, "impaired");
}

/// The small protocol with conditions of its own.
Json withConditions(const std::string& conditions) {
  Json json = smallProtocol();
  json["conditions"] = Json::parse(conditions);
  json.at("survey").at("fields").at(0)["favors"] = {"left", "right"};
  json["blocks"][0]["instructions"][0]["picture"]["condition"] = "right";
  return json;
}

TEST(ProtocolFile, NamesItsConditions) {
  const Protocol protocol = protocolFromJsonText(withConditions(R"([{"name": "left", "view": "pinhole"},
                         {"name": "right", "label": "right one",
                          "view": {"kind": "panes", "headings_degrees": [0, 90]}}])")
                                                     .dump(),
                                                 "study.json");
  EXPECT_EQ(protocol.nameOf(TrialView::kReference), "left");
  EXPECT_EQ(protocol.nameOf(TrialView::kOther), "right");
  EXPECT_EQ(protocol.conditions.names.labelOf(TrialView::kReference), "left");
  EXPECT_EQ(protocol.conditions.names.labelOf(TrialView::kOther), "right one");
  EXPECT_THAT(protocol.survey->fields[0].favors, ElementsAre(TrialView::kReference, TrialView::kOther));
  TrialPlan plan;
  plan.task = "find";
  plan.view = TrialView::kOther;
  const TrialScreen screen{640, 400, 60};
  EXPECT_EQ(protocol.blocks[0].task->start(plan, screen)->layout().views.size(), 2u);
  EXPECT_EQ(protocol.blocks[0].practice->task->start(plan, screen)->layout().views.size(), 2u);
  plan.view = TrialView::kReference;
  EXPECT_EQ(protocol.blocks[0].task->start(plan, screen)->layout().views.size(), 1u);
  EXPECT_EQ(conditionNamesOf(protocol.text, "study.json"), protocol.conditions.names);
}

TEST(ProtocolFile, WithoutConditionsComparesPinholeAndGraphCamera) {
  const Protocol protocol = protocolFromJsonText(smallProtocol().dump(), "study.json");
  EXPECT_EQ(protocol.conditions.names, defaultConditions());
  EXPECT_EQ(conditionNamesOf(protocol.text, "study.json"), defaultConditions());
}

TEST(ProtocolFile, SaysWhatIsWrongWithConditions) {
  const auto errorOf = [](const std::string& conditions) { return protocolError(withConditions(conditions)); };
  EXPECT_THAT(errorOf("[]"), HasSubstr("1 to 16 conditions"));
  EXPECT_THAT(errorOf("{}"), HasSubstr("1 to 16 conditions"));
  std::string many;
  for (int i = 0; i < 17; ++i) {
    many += (i == 0 ? R"([{"name": "c)" : R"(, {"name": "c)") + std::to_string(i) + R"(", "view": "pinhole"})";
  }
  EXPECT_THAT(errorOf(many + "]"), HasSubstr("1 to 16 conditions"));
  EXPECT_THAT(errorOf(R"([{"name": "a", "view": "pinhole"}, {"name": "b", "view": "graph"},
                          {"name": "b", "view": "pinhole"}])"),
              HasSubstr("that of an earlier condition too"));
  EXPECT_THAT(errorOf(R"([{"name": "left", "view": "pinhole"}, {"name": "left", "view": "graph"}])"),
              HasSubstr("that of the other condition too"));
  EXPECT_THAT(errorOf(R"([{"name": "left", "view": "pinhole"}, {"name": "r i", "view": "graph"}])"),
              HasSubstr("letters, digits"));
  EXPECT_THAT(errorOf(R"([{"name": "left", "view": "pinhole"}, {"name": "right"}])"), HasSubstr("\"view\""));
  EXPECT_THAT(errorOf(R"([{"name": "left", "view": "pinhole"}, {"name": "right", "view": "x"}])"),
              HasSubstr("the views are pinhole"));
  EXPECT_THAT(errorOf(R"([{"name": "left", "view": "pinhole", "eye": 1}, {"name": "right", "view": "graph"}])"),
              HasSubstr("eye"));
  EXPECT_THAT(errorOf(R"([{"name": "one", "view": "pinhole"}, {"name": "right", "view": "graph"}])"),
              HasSubstr("must be [\"one\", \"right\"]"))
      << "of favors";
}

TEST(ProtocolFile, PagesNeedExampleCasesToShow) {
  Json json = smallProtocol();
  json["blocks"][0].erase("example_cases");
  EXPECT_THAT(protocolError(json), HasSubstr("field \"picture\" shows a trial, but the block has no field"));
}

TEST(ProtocolFile, AsksForTheVariantsOfItsConditions) {
  const std::string conditions = R"([{"name": "left", "view": {"kind": "pinhole", "variant": "low"}},
                                     {"name": "right", "view": {"kind": "graph", "variant": "high"}}])";
  Json json = withConditions(conditions);
  json["blocks"] = Json::array({json.at("blocks").at(1)});
  json["blocks"][0]["sessions"] = {1, 2};
  EXPECT_THAT(protocolError(json), HasSubstr("asks for the variant \"high\", but a block has \"low\""));
  json["blocks"][0]["variants"]["high"] = {{"comprehensive", {{"eye_height", 5}}}};
  EXPECT_EQ(protocolError(json), "");
  json["blocks"][0].erase("variants");
  EXPECT_THAT(protocolError(json), HasSubstr("but a block has none"));
  json["blocks"][0]["variants"] = {{"low", {{"maze", "ring"}}}};
  EXPECT_THAT(protocolError(json), HasSubstr("field \"maze\" is unknown"));
}

TEST(ProtocolFile, KeepsItsTextByteByByte) {
  const TemporaryFolder folder;
  const std::string text = "// A comment\n" + smallProtocol().dump(3) + "\n\n";
  const auto path = folder.path() / "small.json";
  std::ofstream(path, std::ios::binary) << text;
  const Protocol protocol = readProtocol(path);
  EXPECT_EQ(protocol.text, text);
  EXPECT_EQ(protocol.sha256, sha256(text));
  EXPECT_EQ(protocol.file, path);
  EXPECT_EQ(protocolFromJsonText(protocol.text, "database").sha256, protocol.sha256);
}

TEST(ProtocolFile, HasDefaultsForMostFields) {
  const Json json = Json::parse(R"({"name": "least", "title": "Least",
    "mazes": {"m": {"plan": ["+-+-+", "|   |", "+ +-+"]}},
    "blocks": [{"name": "b", "title": "B", "task": "find", "maze": "m", "cases": [{"row": 0, "column": 1}]}]})");
  const Protocol protocol = protocolFromJsonText(json.dump(), "least.json");
  EXPECT_EQ(protocol.sessions, 1);
  EXPECT_FALSE(protocol.consent || protocol.demographics || protocol.survey);
  EXPECT_FALSE(protocol.blocks[0].practice);
  EXPECT_TRUE(protocol.blocks[0].sessions.empty());
}

TEST(ProtocolFile, TakesTheSmallestExampleOfTheGuide) {
  const std::string guide = fileBytes(OCELLI_SOURCE_DIR "/docs/protocols.md");
  const std::string intro = "```json\n";
  const size_t start = guide.find(intro) + intro.size();
  const Protocol protocol = protocolFromJsonText(guide.substr(start, guide.find("```", start) - start), "guide");
  EXPECT_EQ(protocol.name, "least");
}

struct Mutation {
  const char* at;       ///< JSON pointer of what is replaced, or added
  const char* value;    ///< JSON; empty to take it away
  const char* message;  ///< part of what the error says
  const char* where;    ///< another part
};

class MutatedProtocol : public testing::TestWithParam<Mutation> {};

TEST_P(MutatedProtocol, IsRefusedWithAnErrorThatSaysWhatAndWhere) {
  const Mutation& mutation = GetParam();
  Json json = smallProtocol();
  ASSERT_EQ(protocolError(json), "");
  const Json::json_pointer at(mutation.at);
  if (std::string(mutation.value).empty()) {
    json.at(at.parent_pointer()).erase(at.back());
  } else {
    json[at] = Json::parse(mutation.value);
  }
  const std::string error = protocolError(json);
  EXPECT_THAT(error, HasSubstr(mutation.message)) << mutation.at;
  EXPECT_THAT(error, HasSubstr(mutation.where)) << mutation.at;
  EXPECT_THAT(error, HasSubstr("study.json")) << mutation.at;
}

// clang-format off
const Mutation kMutations[] = {
    // Fields that are unknown, missing or of another type, at each level.
    {"/blcoks", "[]", "field \"blcoks\" is unknown", "use one of"},
    {"/name", "", "field \"name\" is missing", ""},
    {"/name", "\"my study\"", "field \"name\" must be of letters, digits and -", ""},
    {"/name", "\"\"", "field \"name\" must have 1 to 60 characters", ""},
    {"/title", "7", "field \"title\" must be a text", ""},
    {"/sessions", "0", "field \"sessions\" must lie between 1 and 20", ""},
    {"/sessions", "1.5", "field \"sessions\" must be a whole number", ""},
    {"/seed", "-1", "field \"seed\" must lie between", ""},
    {"/seed", "12345678901234567890", "field \"seed\" must lie between", ""},
    {"/minutes_between_sessions", "-5", "field \"minutes_between_sessions\" must lie between", ""},
    {"/break_seconds", "1e5", "field \"break_seconds\" must be a whole number", ""},
    {"/shuffle_blocks", "1", "field \"shuffle_blocks\" must be true or false", ""},
    {"/resume", "\"restart\"", "field \"resume\" must be one of next_trial, restart_block, stop", ""},
    {"/blocks", "[]", "field \"blocks\" must be an array of 1 to 20 blocks", ""},
    {"/blocks", "{}", "field \"blocks\" must be an array", ""},
    {"/blocks/1", "5", "a JSON object { ... } is expected", "\"blocks\" 2"},
    // Pages and forms.
    {"/consent/paragraphs", "[]", "field \"paragraphs\" must be an array of 1 to", "\"consent\""},
    {"/consent/paragraphs/0", "\"\"", "field \"paragraphs\"", "\"consent\""},
    {"/consent/text", "\"x\"", "field \"text\" is unknown", "\"consent\""},
    {"/welcome/0/picture", "\"maze\"", "field \"picture\" must be one of find_ppc", "\"welcome\" 1"},
    {"/welcome/0/picture", R"({"condition": "gc"})", "which only the instructions of a block can", "\"welcome\" 1"},
    {"/blocks/1/instructions/0/picture", R"({"condition": "bent"})", "field \"condition\" must be one of ppc, gc", "\"instructions\" 1"},
    {"/blocks/0/instructions/0/picture/case", "\"here\"", "field \"case\" must be one of seen", "\"instructions\" 1"},
    {"/blocks/0/instructions/0/picture/trial", "1", "field \"trial\" is unknown", "\"instructions\" 1"},
    {"/blocks/0/practice/each_view", "1", "field \"each_view\" must be true or false", "\"practice\""},
    {"/demographics/fields", "[]", "field \"fields\" must be an array of 1 to", "\"demographics\""},
    {"/demographics/fields/0/name", "\"Vision\"", "field \"name\" must be of small letters", "\"fields\" 1"},
    {"/demographics/fields/0/options", "[\"one\"]", "field \"options\" must be an array of 2 to", "\"fields\" 1"},
    {"/demographics/fields/0/options", "[\"a\", \"a\"]", "field \"options\" must be different", "\"fields\" 1"},
    {"/demographics/fields/1", R"({"name": "vision", "question": "?", "options": ["a", "b"]})", "has two of the name \"vision\"", "\"demographics\""},
    {"/survey/fields/0/ends", "[\"a\"]", "field \"ends\" must be an array of 2 to 2", "\"survey\""},
    {"/survey/fields/0/favors", "[\"gc\"]", "field \"favors\" must be [\"ppc\", \"gc\"] or", "\"survey\""},
    {"/survey/fields/0/favors", "[\"gc\", \"gc\"]", "field \"favors\" must be", "\"survey\""},
    {"/survey/fields/0/favors", "[\"ppc\", \"bent\"]", "field \"favors\" must be", "\"survey\""},
    {"/survey/fields/0/favors", "\"gc\"", "field \"favors\" must be", "\"survey\""},
    // Screen, timing, controls.
    {"/screen/refresh_hertz", "0", "field \"refresh_hertz\" must lie between 10 and 1000", "\"screen\""},
    {"/screen/size", "24", "field \"size\" is unknown", "\"screen\""},
    {"/timing/late_factor", "1", "field \"late_factor\" must lie between 1.01 and 10", "\"timing\""},
    {"/controls/forward", "\"Up\"", "field \"forward\"", "\"controls\""},
    {"/controls/walk_meters_per_second", "0", "field \"walk_meters_per_second\"", "\"controls\""},
    // Rules of exclusion.
    {"/exclusions/0/what", "\"form:hearing\"", "neither demographics nor survey ask", "\"exclusions\" 1"},
    {"/exclusions/0/what", "\"age\"", "field \"what\" must be one of", "\"exclusions\" 1"},
    {"/exclusions/0/value", "\"blurred\"", "field \"value\" must be one of: normal, impaired", "\"exclusions\" 1"},
    {"/exclusions/0/value", "true", "field \"value\" must be a text or a number", "\"exclusions\" 1"},
    {"/exclusions/0/test", "\"at_most\"", "field \"test\" must be is or is_not", "\"exclusions\" 1"},
    {"/exclusions/0", R"({"what": "timeout_share", "test": "at_least", "value": 1.5, "reason": "slow"})", "field \"value\" must be a number between 0 and 1", ""},
    {"/exclusions/0", R"({"what": "sessions_completed", "test": "is", "value": 1, "reason": "few"})", "field \"test\" must be at_least or at_most", ""},
    {"/exclusions/0", R"({"what": "sessions_completed", "test": "at_most", "value": "1x", "reason": "few"})", "field \"value\" must be a number between 0 and 2", ""},
    {"/exclusions/0/reason", "", "field \"reason\" is missing", "\"exclusions\" 1"},
    // Mazes.
    {"/mazes/ring/landmarks", "[]", "field \"landmarks\" is not for protocols", "\"mazes\" ring"},
    {"/mazes/ring/plan/1", "\"|  |  |\"", "", "\"mazes\" ring"},
    {"/mazes/ring/plan/0", "\"+ +-+-+\"", "two entrances", "\"mazes\" ring"},
    {"/mazes/ring/plan/6", "\"+-+-+-+\"", "no entrance", "\"mazes\" ring"},
    {"/mazes/ring/plan/4", "\"+-+ +-+\"", "cannot be reached", "\"mazes\" ring"},
    {"/mazes/ring/wall_thickness", "2", "wall", "\"mazes\" ring"},
    {"/mazes", "[]", "field \"mazes\" must be an object", ""},
    // Blocks.
    {"/blocks/0/task", "\"search\"", "field \"task\" must be one of find, count, path", "\"blocks\" 1 (find it)"},
    {"/blocks/0/task", "", "field \"task\" is missing", "\"blocks\" 1 (find it)"},
    {"/blocks/0/name", "\"a_b\"", "field \"name\" must be of letters, digits, - and spaces", "\"blocks\" 1"},
    {"/blocks/1/name", "\"find it\"", "has two of the name \"find it\": the second is block 2", ""},
    {"/blocks/0/order", "\"random\"", "field \"order\" must be one of alternating, balanced", "\"blocks\" 1 (find it)"},
    {"/blocks/0/views", "\"two\"", "field \"views\" must be one of both, one", "\"blocks\" 1 (find it)"},
    {"/blocks/0/feedback", "\"yes\"", "field \"feedback\" must be true or false", "\"blocks\" 1 (find it)"},
    {"/blocks/0/break_every_trials", "-1", "field \"break_every_trials\" must lie", "\"blocks\" 1 (find it)"},
    {"/blocks/0/exposure_seconds", "5", "field \"exposure_seconds\" is unknown", "\"blocks\" 1 (find it)"},
    {"/blocks/0/sessions", "[3]", "field \"sessions\" must be an array of whole numbers from 1 to 2", "\"blocks\" 1 (find it)"},
    {"/blocks/0/sessions", "[]", "field \"sessions\" must be an array", "\"blocks\" 1 (find it)"},
    {"/blocks/1/sessions", "[1, 1]", "field \"sessions\" has a session twice", "\"blocks\" 2 (count them)"},
    {"/blocks/0/practice/least_correct", "3", "field \"least_correct\" must be at most \"most_trials\"", "\"practice\""},
    {"/blocks/0/practice/most_trials", "0", "field \"most_trials\" must lie between 1 and 100", "\"practice\""},
    {"/blocks/0/practice", "", "field \"practice_cases\" is of no use without", "\"blocks\" 1 (find it)"},
    {"/blocks/0/practice_cases", "", "field \"practice_cases\" is missing", "\"blocks\" 1 (find it)"},
    // Tasks: what cannot be.
    {"/blocks/0/maze", "\"loop\"", "field \"maze\" is \"loop\", but the mazes of this protocol are: ring", "\"blocks\" 1 (find it)"},
    {"/blocks/0/cases", "[]", "field \"cases\" must be an array of 1 to 1000 cases", "\"blocks\" 1 (find it)"},
    {"/blocks/0/cases", "", "field \"cases\" is missing", "\"blocks\" 1 (find it)"},
    {"/blocks/0/cases/0/east", "0.45", "wall", "\"cases\" 1"},
    {"/blocks/0/cases/0/row", "3", "field \"row\" must lie between 0 and 2", "\"cases\" 1"},
    {"/blocks/0/cases/1/label", "\"here\"", "field \"label\" is \"here\"", "\"cases\" 2"},
    {"/blocks/0/limit_seconds", "0", "field \"limit_seconds\"", "\"blocks\" 1 (find it)"},
    {"/blocks/0/moving/meters_per_second", "-1", "field \"meters_per_second\"", "\"moving\""},
    {"/blocks/0/object/color", "\"red\"", "field \"color\" must be one of orange", "\"object\""},
    {"/blocks/0/portals/bent_beyond", "20", "\"bent_beyond\" must be less than \"farthest\"", "\"portals\""},
    {"/blocks/1/cases/0/objects", "6", "field \"objects\" is 6, but there are 5 places", "\"cases\" 1"},
    {"/blocks/1/cases/0/exposure_seconds", "-5", "field \"exposure_seconds\" must lie", "\"cases\" 1"},
    {"/blocks/1/cases/0/exposure_seconds", "", "field \"exposure_seconds\" is missing", "\"cases\" 1"},
    {"/blocks/1/most_answer", "4", "field \"most_answer\" must be more than", "\"blocks\" 2 (count them)"},
    {"/blocks/1/pinholes", "", "field \"pinholes\" is missing", "\"blocks\" 2 (count them)"},
    {"/blocks/1/pinholes/views/0/east", "-0.5", "puts the eye into a wall", "\"views\" 1"},
    {"/blocks/1/pinholes/rows", "0", "field \"rows\" must lie", "\"pinholes\""},
    {"/blocks/2/most_seconds", "2", "field \"most_seconds\" is less than", "\"blocks\" 3 (path)"},
    {"/blocks/2/turns", "7", "field \"turns\" must lie between 1 and 6", "\"blocks\" 3 (path)"},
    {"/blocks/2/meters_per_second", "0.1", "at 0.1 m/s no path of 2 turns lasts 3 to 20 s", "\"blocks\" 3 (path)"},
    {"/blocks/2/maps", "1", "field \"maps\" must lie between 2 and 5", "\"blocks\" 3 (path)"},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(ProtocolFile, MutatedProtocol, testing::ValuesIn(kMutations));

TEST(ProtocolFile, RefusesSessionsWithoutBlocks) {
  Json json = smallProtocol();
  json["sessions"] = 3;
  EXPECT_THAT(protocolError(json), HasSubstr("field \"sessions\" is 3, but no block is in session 3"));
}

TEST(ProtocolFile, SaysTheLineOfAField) {
  Json json = smallProtocol();
  json.at("blocks").at(0).at("cases").at(0)["row"] = 9;
  const std::string text = json.dump(1);
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("\"row\": 9")), '\n');
  try {
    protocolFromJsonText(text, "study.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("study.json:" + std::to_string(line) +
                                        ", \"blocks\" 1 (find it), \"cases\" 1: field \"row\" must lie"));
    EXPECT_THAT(error.what(), HasSubstr("see protocols/protocol.schema.json"));
  }
}

TEST(ProtocolFile, SaysWhereTheJsonIsBroken) {
  try {
    protocolFromJsonText("{\n  \"name\": \"x\"\n  \"title\": 1}", "study.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("study.json:3:"));
  }
  EXPECT_THROW(readProtocol("/no/such/protocol.json"), InputError);
}

}  // namespace
}  // namespace ocelli::test
