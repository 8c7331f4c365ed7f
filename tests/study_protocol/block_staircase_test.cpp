// Staircases of blocks as protocols describe them.
#include "study/protocol/block_staircase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/protocol/check_report.h"
#include "study/protocol/protocol_warnings.h"
#include "study/protocol/session_length.h"
#include "tests/study_protocol/protocol_text.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

/// One block of three levels, in a falling order.
Json staircaseProtocol() {
  return Json::parse(R"({
    "name": "steps", "title": "Steps", "seed": 5,
    "mazes": {"hall": {"plan": ["+-+-+-+-+", "|       |", "+ +-+-+-+"]}},
    "blocks": [{"name": "nearer", "title": "Nearer", "task": "nearer", "maze": "hall",
      "start": {"row": 0, "column": 0, "heading": "east"},
      "instructions": [{"title": "Nearer", "paragraphs": ["Which?"]}],
      "practice": {}, "practice_cases": [
        {"left": {"row": 0, "column": 2, "south": -0.2}, "right": {"row": 0, "column": 3, "south": 0.2}}],
      "staircase": {"method": "quest_plus", "trials": 25},
      "cases": [
        {"label": "much", "level": 0.5, "left": {"row": 0, "column": 2, "south": -0.2},
                                        "right": {"row": 0, "column": 3, "south": 0.2}},
        {"label": "little", "level": 0.1, "left": {"row": 0, "column": 2, "south": -0.2},
                                          "right": {"row": 0, "column": 2, "east": 0.15, "south": 0.2}},
        {"label": "some", "level": 0.25, "left": {"row": 0, "column": 2, "south": -0.2},
                                         "right": {"row": 0, "column": 2, "east": 0.3, "south": 0.2}}]}]})");
}

Json& blockOf(Json& json) {
  return json.at("blocks").at(0);
}

TEST(BlockStaircase, SortsCasesByTheirLevels) {
  const Protocol protocol = protocolFromJsonText(staircaseProtocol().dump(), "test");
  const ProtocolBlock& block = protocol.blocks.front();
  ASSERT_NE(block.staircase, nullptr);
  EXPECT_EQ(block.staircase->levels, (std::vector<double>{0.1, 0.25, 0.5}));
  EXPECT_EQ(block.staircase->cases, (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(block.staircase->levelsByCase(), (std::vector<double>{0.5, 0.1, 0.25}));
  EXPECT_EQ(block.staircase->levelOf(0), 2u);
  EXPECT_EQ(block.staircase->middleCase(), 2);
  EXPECT_EQ(block.staircase->trials, 25);
  EXPECT_EQ(block.task->caseInfo(1).level, 0.1);
  EXPECT_EQ(block.task->caseInfo(1).label, "little");
  EXPECT_FALSE(block.practice->task->caseInfo(0).level.has_value());
}

TEST(BlockStaircase, TrialsTellTheirLevel) {
  const Protocol protocol = protocolFromJsonText(staircaseProtocol().dump(), "test");
  TrialPlan plan = scheduleOf(protocol, 0, 1, 5).trials.front();
  plan.caseIndex = 1;
  const auto run = protocol.blocks.front().task->start(plan, {640, 400, 60});
  run->handle(KeyEvent{Key::kLeft, true, {}});
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->measures.at("level"), 0.1);
  EXPECT_EQ(run->outcome()->measures.size(), 3u);
}

TEST(BlockStaircase, TheGuessRateIsThatOfTheTaskOrTheProtocol) {
  Json json = staircaseProtocol();
  const auto summary = [&] {
    return protocolFromJsonText(json.dump(), "test").blocks.front().staircase->rule->summary();
  };
  EXPECT_THAT(summary(), HasSubstr("guesses 0.5"));
  blockOf(json)["staircase"]["guess_rate"] = 0.25;
  EXPECT_THAT(summary(), HasSubstr("guesses 0.25"));
  blockOf(json)["staircase"] = {{"method", "up_down"}, {"right_in_a_row", 2}};
  EXPECT_THAT(summary(), HasSubstr("70.7 %"));
}

TEST(BlockStaircase, RefusesWhatItCannotUse) {
  const auto errorWith = [](const std::function<void(Json & block)>& change) {
    Json json = staircaseProtocol();
    change(blockOf(json));
    return protocolError(json);
  };
  EXPECT_EQ(errorWith([](Json&) {}), "");
  EXPECT_THAT(errorWith([](Json& block) { block.erase("staircase"); }),
              AllOf(HasSubstr("field \"level\""), HasSubstr("without the field \"staircase\"")));
  EXPECT_THAT(errorWith([](Json& block) { block["cases"][1].erase("level"); }), HasSubstr("field \"level\""));
  EXPECT_THAT(errorWith([](Json& block) { block["cases"][1]["level"] = 0; }), HasSubstr("field \"level\""));
  EXPECT_THAT(errorWith([](Json& block) { block["cases"][1]["level"] = 0.5; }),
              HasSubstr("is 0.5, which another case of the block has"));
  EXPECT_THAT(errorWith([](Json& block) { block["practice_cases"][0]["level"] = 0.5; }), HasSubstr("these alone"));
  EXPECT_THAT(errorWith([](Json& block) { block["views"] = "one"; }), HasSubstr("a staircase of its own"));
  EXPECT_THAT(errorWith([](Json& block) { block["staircase"]["method"] = "guess"; }), HasSubstr("\"method\""));
  EXPECT_THAT(errorWith([](Json& block) { block["staircase"]["right_in_a_row"] = 3; }),
              HasSubstr("field \"right_in_a_row\" is unknown"));
  EXPECT_THAT(errorWith([](Json& block) { block["staircase"]["most_slope"] = 0.5; }), HasSubstr("least_slope"));
  EXPECT_THAT(errorWith([](Json& block) {
                block["cases"].erase(2);
                block["cases"].erase(1);
              }),
              HasSubstr("a single level"));
}

TEST(BlockStaircase, StudyCheckTellsLevelsAndTrials) {
  const Protocol protocol = protocolFromJsonText(staircaseProtocol().dump(), "test");
  const std::string report = checkReport(protocol, {});
  EXPECT_THAT(report, AllOf(HasSubstr("25 trials each"), HasSubstr("levels: 0.1 0.25 0.5"), HasSubstr("(staircase)")));
  CheckOptions options;
  options.asJson = true;
  const Json json = Json::parse(checkReport(protocol, options));
  EXPECT_EQ(json.at("staircases").at(0).at("levels").size(), 3u);
  EXPECT_TRUE(json.at("schedule").at("trials").at(0).at("case").is_null());
  const auto parts = partsOf(protocol, scheduleOf(protocol, 0, 1, 5));
  EXPECT_EQ(parts.at(1).trials, 50) << "25 of each of two conditions";
  EXPECT_THAT(warningsOf(protocol, 5), testing::Contains(HasSubstr("have 3 levels")));
}

}  // namespace
}  // namespace ocelli::test
