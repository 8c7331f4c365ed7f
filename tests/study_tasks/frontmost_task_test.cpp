// Which of two is in front: the answer by hand, its keys, what is refused, and how the observer tells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/agent/visibility_sensor.h"
#include "study/tasks/frontmost_policy.h"
#include "study/tasks/task_registry.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr TrialScreen kFrontScreen{640, 400, 60};

/// Seen to the east along a corridor of cells of 3 m, from (2, 0); objects are 0.78 m thick.
std::string frontJson(const std::string& left, const std::string& right, const std::string& more = "") {
  return R"({"maze": "small", "answer_limit_seconds": 5, "start": {"row": 2, "column": 0, "heading": "east"})" + more +
         R"(, "cases": [{"label": "a", "left": {)" + left + R"(}, "right": {)" + right + "}}]}";
}
const std::string kLeftFront = R"("ahead_meters": 5, "right_meters": -0.2)";
const std::string kRightBehind = R"("ahead_meters": 6, "right_meters": 0.2)";

std::unique_ptr<TrialRun> frontRun(const TaskBlock& block, int caseIndex = 0) {
  return block.start(test::planOf("frontmost", caseIndex, TrialView::kReference), kFrontScreen);
}

TEST(FrontTask, TheOneInFrontIsRight) {
  const auto block = test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind));
  EXPECT_EQ(block->answerOf(test::planOf("frontmost", 0, TrialView::kOther)), "left");
  EXPECT_EQ(block->caseInfo(0).objects, 2);
  EXPECT_TRUE(block->isStill());
  const auto other = test::readBlock("frontmost", frontJson(R"("ahead_meters": 6, "right_meters": -0.2)",
                                                            R"("ahead_meters": 5, "right_meters": 0.2)"));
  EXPECT_EQ(other->answerOf(test::planOf("frontmost", 0, TrialView::kOther)), "right");
}

TEST(FrontTask, TheArrowsAnswerAtOnce) {
  const auto block = test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind));
  for (const bool isLeft : {true, false}) {
    const auto run = frontRun(*block);
    for (int i = 0; i < 360; ++i) {
      EXPECT_EQ(run->layout().tick, i);
      run->advance();
    }
    run->handle(test::press(isLeft ? Key::kLeft : Key::kRight));
    ASSERT_TRUE(run->outcome().has_value());
    EXPECT_EQ(run->outcome()->answer, isLeft ? "left" : "right");
    EXPECT_EQ(run->outcome()->correct, isLeft);
    EXPECT_EQ(run->outcome()->responseTicks, 360);
    EXPECT_NEAR(run->outcome()->measures.at("left_distance_m"), std::hypot(5, 0.2), 1e-12);
    EXPECT_NEAR(run->outcome()->measures.at("right_distance_m"), std::hypot(6, 0.2), 1e-12);
    // Two discs of radii 0.39 / 5 and 0.39 / 6 with middles 0.2 / 5 + 0.2 / 6 apart: the lens that both share is 0.452
    // of the smaller one. Of its about 1,000 pixels some percent are at the rim.
    EXPECT_NEAR(run->outcome()->measures.at("covered_share"), 0.452, 0.02);
  }
}

TEST(FrontTask, SoDoesAClickOnAChoice) {
  const auto block = test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind));
  const auto run = frontRun(*block);
  const TrialLayout layout = run->layout();
  ASSERT_EQ(layout.choices.size(), 2u);
  EXPECT_FALSE(layout.pointer.has_value()) << "it would lie upon the objects";
  run->handle(test::moveTo(layout.views.front().place.center() + 1.0));
  EXPECT_TRUE(run->layout().pointer.has_value());
  run->handle(test::button(PointerButton::kLeft, true));
  EXPECT_FALSE(run->outcome().has_value()) << "a click on the image is no answer";
  run->handle(test::moveTo(layout.choices[1].place.center()));
  run->handle(test::button(PointerButton::kLeft, true));
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_EQ(run->outcome()->answer, "right");
}

TEST(FrontTask, EndsWithoutAnAnswer) {
  const auto block = test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind));
  const auto run = frontRun(*block);
  for (int i = 0; i < 5 * kTicksPerSecond; ++i) {
    EXPECT_FALSE(run->outcome().has_value());
    run->advance();
  }
  ASSERT_TRUE(run->outcome().has_value());
  EXPECT_TRUE(run->outcome()->censored);
  EXPECT_FALSE(run->outcome()->correct);
}

TEST(FrontTask, RefusesCasesWithoutARightAnswer) {
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront, R"("ahead_meters": 5.5, "right_meters": 0.2)")),
              AllOf(HasSubstr("neither is wholly in front"), HasSubstr("cases\" 1")));
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront, R"("ahead_meters": 6, "right_meters": 0.9)")),
              HasSubstr("0 % of the object behind are covered"));
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront, R"("ahead_meters": 6, "right_meters": -0.22)")),
              HasSubstr("are covered"));
  EXPECT_THAT(test::readError("frontmost", frontJson(R"("ahead_meters": 5, "right_meters": 0.2)",
                                                     R"("ahead_meters": 6, "right_meters": -0.2)")),
              HasSubstr("not to the left"));
  EXPECT_THAT(test::readError("frontmost", frontJson(R"("ahead_meters": 0.7, "right_meters": -0.2)", kRightBehind)),
              HasSubstr("border"));
  EXPECT_THAT(test::readError("frontmost", frontJson(R"("ahead_meters": 5, "right_meters": -1.2)", kRightBehind)),
              HasSubstr("into a wall"));
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront + R"(, "up_meters": -1.5)", kRightBehind)),
              HasSubstr("floor"));
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront, kRightBehind + R"(, "color": "orange")")),
              HasSubstr("both objects are orange"));
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront + R"(, "shape": "arch")", kRightBehind)),
              HasSubstr("arch"));
}

// Behind the wall at the end of the corridor.
TEST(FrontTask, RefusesWhatAWallHides) {
  EXPECT_NE(test::readError("frontmost", frontJson(R"("ahead_meters": 30, "right_meters": -0.2)",
                                                   R"("ahead_meters": 31, "right_meters": 0.2)")),
            "");
}

/// Of a view that holds nothing.
class NowhereView final : public SceneView {
 public:
  std::vector<TrialLayout::View> views(const Vantage& from) const override { return pinholeView()->views(from); }
  bool reaches(const PinholeCamera& /*pinhole*/, const Box& box) const override { return box.lower.x > 1e6f; }
};

TEST(FrontTask, RefusesWhatAConditionCannotShow) {
  TaskSetting setting = test::studySetting();
  setting.conditions.views[1] = std::make_shared<NowhereView>();
  EXPECT_THAT(test::readError("frontmost", frontJson(kLeftFront, kRightBehind), setting),
              HasSubstr("the view gc does not reach the left object"));
}

TEST(FrontPolicy, KnowsHowShapesLook) {
  // A ball is as wide as it is high, and a disc has pi / 4 of its square.
  const WholeShape ball = wholeShape(LandmarkShape::kSphere);
  EXPECT_NEAR(ball.height, 2, 0.02);
  EXPECT_NEAR(ball.areaOfHeight, kPi / 4, 0.02);
  // A cone is half of the rectangle around it.
  const WholeShape cone = wholeShape(LandmarkShape::kCone);
  EXPECT_NEAR(cone.areaOfHeight, 0.5 * 2 / cone.height, 0.05);
}

/// The share of right answers of observers with as many seeds.
double rightShare(const TaskBlock& block, int seeds, const std::function<void(Percept&)>& change = {}) {
  HumanFactors factors;
  factors.slip = 0;
  const Vision vision(factors, 640 / 46.7);
  const Controls controls;
  const VisibilitySensor eye(kFrontScreen);
  int right = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto run = frontRun(block);
    const auto policy = taskKind("frontmost", "test").policy({vision, controls, {}, static_cast<uint64_t>(seed)});
    MotorModel motor(factors, controls, static_cast<uint64_t>(seed));
    int64_t now = 0;
    Percept seen = eye.look(run->layout(), false);
    if (change) {
      change(seen);
    }
    for (int i = 0; i < 20 && !run->outcome(); ++i, now += 300'000'000) {
      policy->think(seen, now, now + 300'000'000, motor);
      for (const TimedInput& input : motor.take(now + 300'000'000)) {
        run->handle(input.event);
      }
    }
    right += run->outcome() && run->outcome()->correct ? 1 : 0;
  }
  return static_cast<double>(right) / seeds;
}

TEST(FrontPolicy, TakesWhatShowsWholeForTheOneInFront) {
  EXPECT_EQ(rightShare(*test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind)), 40), 1);
  // What looks small, as it is farther away, shows whole all the same where it is in front of what is covered.
  EXPECT_EQ(rightShare(*test::readBlock("frontmost", frontJson(R"("ahead_meters": 6, "right_meters": -0.2)",
                                                               R"("ahead_meters": 5.1, "right_meters": 0.2)")),
                       40),
            1);
}

// Where either shows whole only sizes are left, and where they are alike too it guesses.
TEST(FrontPolicy, GuessesWhereNothingTells) {
  const auto block = test::readBlock("frontmost", frontJson(kLeftFront, kRightBehind));
  const double share = rightShare(*block, 200, [](Percept& seen) {
    for (Sighting& each : seen.objects) {
      each.upper = each.lower + glm::dvec2(40, 40);
      each.pixels = 1256;  // pi / 4 of the square
    }
  });
  EXPECT_NEAR(share, 0.5, 0.15);  // 4 standard deviations of 200 guesses
}

}  // namespace
}  // namespace ocelli
