// Which of two is nearer: the answer by hand, its keys, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/agent/visibility_sensor.h"
#include "study/tasks/task_registry.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr TrialScreen kNearerScreen{640, 400, 60};

/// Seen to the east along a corridor of cells of 3 m, from (2, 0): north is left.
std::string nearerJson(const std::string& left, const std::string& right, const std::string& more = "") {
  return R"({"maze": "small", "answer_limit_seconds": 5, "start": {"row": 2, "column": 0, "heading": "east"})" + more +
         R"(, "cases": [{"label": "a", "left": {)" + left + R"(}, "right": {)" + right + "}}]}";
}
const std::string kNear = R"("row": 2, "column": 2, "south": -0.25)";
const std::string kFar = R"("row": 2, "column": 4, "south": 0.25)";

std::unique_ptr<TrialRun> nearerRun(const TaskBlock& block) {
  return block.start(test::planOf("nearer", 0, TrialView::kReference), kNearerScreen);
}

TEST(NearerTask, TheNearerSideIsRight) {
  const auto block = test::readBlock("nearer", nearerJson(kNear, kFar));
  EXPECT_EQ(block->answerOf(test::planOf("nearer", 0, TrialView::kOther)), "left");
  EXPECT_EQ(block->caseInfo(0).objects, 2);
  const auto farther = test::readBlock("nearer", nearerJson(R"("row": 2, "column": 5, "south": -0.25)", kFar));
  EXPECT_EQ(farther->answerOf(test::planOf("nearer", 0, TrialView::kOther)), "right");
}

TEST(NearerTask, TheArrowsAnswerAtOnce) {
  const auto block = test::readBlock("nearer", nearerJson(kNear, kFar));
  for (const bool isLeft : {true, false}) {
    const auto run = nearerRun(*block);
    for (int i = 0; i < 480; ++i) {
      run->advance();
    }
    run->handle(test::press(isLeft ? Key::kLeft : Key::kRight));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_EQ(run->outcome()->answer, isLeft ? "left" : "right");
    EXPECT_EQ(run->outcome()->correct, isLeft);
    EXPECT_FALSE(run->outcome()->censored);
    EXPECT_EQ(run->outcome()->responseTicks, 480);
    // 6 m and 12 m to the east, 0.75 m to the sides.
    ASSERT_EQ(run->outcome()->measures.size(), 2u);
    EXPECT_NEAR(run->outcome()->measures.at("left_distance_m"), std::hypot(6, 0.75),
                1e-5);  // places are of single precision
    EXPECT_NEAR(run->outcome()->measures.at("right_distance_m"), std::hypot(12, 0.75), 1e-5);
  }
}

TEST(NearerTask, SoDoesAClickOnAChoice) {
  const auto block = test::readBlock("nearer", nearerJson(kNear, kFar));
  const auto run = nearerRun(*block);
  const TrialLayout layout = run->layout();
  ASSERT_EQ(layout.choices.size(), 2u);
  EXPECT_LT(layout.choices[0].place.right(), layout.choices[1].place.left + 1);
  run->handle(test::moveTo(layout.views.front().place.center()));
  run->handle(test::button(PointerButton::kLeft, true));
  EXPECT_FALSE(run->outcome().has_value()) << "a click on the image is no answer";
  run->handle(test::moveTo(layout.choices[1].place.center()));
  run->handle(test::button(PointerButton::kLeft, true));
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->answer, "right");
}

TEST(NearerTask, MirroredCasesHaveTheOtherAnswerInHalfOfTheTrials) {
  const auto plain = test::readBlock("nearer", nearerJson(kNear, kFar));
  const auto mirrored = test::readBlock("nearer", nearerJson(kNear, kFar, R"(, "mirrored": true)"));
  int swapped = 0;
  constexpr int kSeeds = 200;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const TrialPlan plan = test::planOf("nearer", 0, TrialView::kReference, seed);
    EXPECT_EQ(plain->answerOf(plan), "left");
    const auto run = mirrored->start(plan, kNearerScreen);
    const TrialLayout layout = run->layout();
    const bool isSwapped = mirrored->answerOf(plan) == "right";
    swapped += isSwapped ? 1 : 0;
    // Looking east: the objects stand 0.75 m to the north and to the south.
    EXPECT_NEAR(layout.objectOffsets.at(0).x, isSwapped ? 6 : 0, 1e-5);
    EXPECT_NEAR(layout.objectOffsets.at(1).x, isSwapped ? -6 : 0, 1e-5);
    EXPECT_NEAR(layout.objectOffsets.at(0).z, 0, 1e-5);
    run->handle(test::press(isSwapped ? Key::kRight : Key::kLeft));
    EXPECT_TRUE(run->outcome()->correct);
    EXPECT_EQ(run->outcome()->expected, mirrored->answerOf(plan));
    EXPECT_NEAR(run->outcome()->measures.at(isSwapped ? "right_distance_m" : "left_distance_m"), std::hypot(6, 0.75),
                1e-5);
  }
  // 100 of 200 by chance, with a standard deviation of 7.
  EXPECT_NEAR(swapped, kSeeds / 2, 4 * 7.1);
}

TEST(NearerTask, RefusesMirrorImagesThatStandInWallsOrOutside) {
  // From the southern end of a column of cells, looking east along a wall: the mirror image lies beyond it.
  const auto errorOf = [](const std::string& more) {
    return test::readError("nearer", nearerJson(kNear, R"("row": 2, "column": 3, "south": 0.1)", more));
  };
  EXPECT_EQ(errorOf(""), "");
  EXPECT_EQ(errorOf(R"(, "mirrored": true)"), "");
  EXPECT_THAT(test::readError("nearer", R"({"maze": "small", "mirrored": true,
      "start": {"row": 0, "column": 0, "heading": "east"}, "cases": [
      {"left": {"row": 0, "column": 2, "south": -0.2}, "right": {"row": 1, "column": 3, "south": 0.2}}]})"),
              HasSubstr("mirror"));
}

TEST(NearerTask, NobodyWalks) {
  const auto block = test::readBlock("nearer", nearerJson(kNear, kFar));
  const auto run = nearerRun(*block);
  const WalkerPose before = run->pose();
  run->handle(test::press(Key::kW));
  for (int i = 0; i < 240; ++i) {
    run->advance();
  }
  EXPECT_EQ(run->pose(), before);
  EXPECT_NEAR(before.headingRadians, std::acos(0), 1e-6);
}

TEST(NearerTask, RefusesCasesWithoutARightAnswer) {
  EXPECT_THAT(test::readError("nearer", nearerJson(kNear, R"("row": 2, "column": 2, "south": 0.25)")),
              AllOf(HasSubstr("neither is nearer"), HasSubstr("case \"a\"")));
  EXPECT_THAT(test::readError("nearer", nearerJson(kFar, kNear)), HasSubstr("wholly to the left"));
  EXPECT_THAT(test::readError("nearer", nearerJson(R"("row": 4, "column": 0)", kFar)),
              AllOf(HasSubstr("shows 0 pixels of the left object")));
  EXPECT_THAT(test::readError("nearer", nearerJson(R"("row": 2, "column": 1, "south": -0.25)", kFar)),
              HasSubstr("the border of the image of the view ppc cuts off the left object"));
  EXPECT_THAT(test::readError("nearer", nearerJson(R"("row": 2, "column": 2, "south": -0.5)", kFar)),
              HasSubstr("wall"));
  EXPECT_THAT(test::readError("nearer", nearerJson(R"("row": 2, "column": 9)", kFar)), HasSubstr("column"));
  EXPECT_THAT(test::readError("nearer", R"({"maze": "small", "cases": [{"left": {"row": 1, "column": 1}}]})"),
              HasSubstr("right"));
}

// What looks taller seems nearer, and slips aside the observer is right where heights differ by half.
TEST(NearerTask, TheObserverTakesTheTallerOneForTheNearer) {
  HumanFactors factors;
  factors.slip = 0;
  const Vision vision(factors, 640 / 46.7);
  const Controls controls;
  const VisibilitySensor eye(kNearerScreen);
  const auto block = test::readBlock("nearer", nearerJson(kNear, kFar));
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const auto run = nearerRun(*block);
    const auto policy = taskKind("nearer", "test").policy({vision, controls, {}, seed});
    MotorModel motor(factors, controls, seed);
    int64_t now = 0;
    for (int i = 0; i < 10 && !run->outcome(); ++i, now += 300'000'000) {
      policy->think(eye.look(run->layout(), false), now, now + 300'000'000, motor);
      for (const TimedInput& input : motor.take(now + 300'000'000)) {
        run->handle(input.event);
      }
    }
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_TRUE(run->outcome()->correct);
  }
}

}  // namespace
}  // namespace ocelli
