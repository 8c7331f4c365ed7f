// How far: the truth by hand, mouse and keys, time that runs out, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/tasks/task_registry.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr TrialScreen kDistanceScreen{640, 400, 60};

/// Seen to the east along a corridor of cells of 3 m, from (2, 0).
std::string distanceJson(const std::string& place, const std::string& more = "") {
  return R"({"maze": "small", "answer_limit_seconds": 5, "start": {"row": 2, "column": 0, "heading": "east"})" + more +
         R"(, "cases": [{"label": "a", )" + place + "}]}";
}
const std::string kSixMetres = R"("row": 2, "column": 2)";

std::unique_ptr<TrialRun> distanceRun(const TaskBlock& block) {
  return block.start(test::planOf("distance", 0, TrialView::kReference), kDistanceScreen);
}

void answer(TrialRun& run, double meters) {
  const TrialLayout::Scale scale = run.layout().scale.value();
  const double share = meters / scale.most;
  run.handle(test::moveTo({scale.place.left + share * scale.place.width, scale.place.center().y}));
  run.handle(test::button(PointerButton::kLeft, true));
  run.handle(test::button(PointerButton::kLeft, false));
}

TEST(DistanceTask, TheTruthIsTheStraightLineOnTheFloor) {
  // 3 cells of 3 m to the east and a quarter of one aside.
  const auto block = test::readBlock("distance", distanceJson(R"("row": 2, "column": 3, "south": 0.25)"));
  const auto run = distanceRun(*block);
  answer(*run, 10);
  run->handle(test::press(Key::kEnter));
  const double truth = std::hypot(9, 0.75);
  EXPECT_NEAR(run->outcome()->measures.at("truth_m"), truth, 1e-5);  // places are of single precision
  EXPECT_NEAR(run->outcome()->measures.at("estimate_m"), 10, 30.0 / 400) << "a pixel of the scale";
  EXPECT_EQ(run->outcome()->measures.size(), 2u);
  EXPECT_NEAR(std::stod(block->answerOf(test::planOf("distance", 0, TrialView::kOther))), truth, 1e-4);
}

TEST(DistanceTask, IsRightWithinAShareEitherWay) {
  const auto block = test::readBlock("distance", distanceJson(kSixMetres, R"(, "right_within": 0.25)"));
  for (const auto& [meters, right] :
       std::vector<std::pair<double, bool>>{{7.4, true}, {7.6, false}, {4.9, true}, {4.7, false}}) {
    const auto run = distanceRun(*block);
    answer(*run, meters);
    run->handle(test::press(Key::kEnter));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_EQ(run->outcome()->correct, right) << run->outcome()->answer;
    EXPECT_FALSE(run->outcome()->censored);
  }
}

TEST(DistanceTask, KeysAloneAnswerAndTheTimeIsThatOfEnter) {
  const auto block = test::readBlock("distance", distanceJson(kSixMetres));
  const auto run = distanceRun(*block);
  for (int i = 0; i < 20; ++i) {
    run->handle(test::press(Key::kRight));
    run->advance();
    run->handle(test::release(Key::kRight));
  }
  EXPECT_FALSE(run->outcome().has_value());
  for (int i = 0; i < 220; ++i) {
    run->advance();
  }
  run->handle(test::press(Key::kEnter));
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->answer, "3") << "20 steps of 0.15 m";
  EXPECT_EQ(run->outcome()->responseTicks, 240);
}

TEST(DistanceTask, AMarkThatWasNotConfirmedIsNoAnswer) {
  const auto block = test::readBlock("distance", distanceJson(kSixMetres));
  const auto run = distanceRun(*block);
  answer(*run, 4);
  for (int i = 0; i < 5 * 240; ++i) {
    run->advance();
  }
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_TRUE(run->outcome()->censored);
  EXPECT_FALSE(run->outcome()->correct);
  EXPECT_EQ(run->outcome()->answer, "");
  EXPECT_TRUE(run->outcome()->measures.empty());
  EXPECT_EQ(run->outcome()->responseTicks, 5 * 240);
}

TEST(DistanceTask, RefusesWhatCannotBeAnswered) {
  EXPECT_THAT(test::readError("distance", distanceJson(R"("row": 2, "column": 3)", R"(, "scale_meters": 8)")),
              AllOf(HasSubstr("9.00 m away, beyond the scale of 8 m"), HasSubstr("case \"a\"")));
  EXPECT_THAT(test::readError("distance", distanceJson(R"("row": 2, "column": 0, "east": 0.1)")),
              HasSubstr("the object is 0.30 m from where one stands"));
  EXPECT_THAT(test::readError("distance", distanceJson(R"("row": 4, "column": 0)")), HasSubstr("shows 0 pixels"));
  EXPECT_THAT(test::readError("distance", distanceJson(R"("row": 2, "column": 2, "south": -0.5)")), HasSubstr("wall"));
  EXPECT_THAT(test::readError("distance", distanceJson(R"("row": 2, "column": 1)")), HasSubstr("cuts off the object"));
  EXPECT_THAT(test::readError("distance", distanceJson(kSixMetres, R"(, "right_within": 0)")),
              HasSubstr("right_within"));
}

}  // namespace
}  // namespace ocelli
