// Where an object seems to stand in a picture, and what a simulated observer says of it.
#include "study/tasks/estimate_policy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "study/agent/visibility_sensor.h"
#include "study/tasks/task_registry.h"
#include "study/trial/estimated_value.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr TrialScreen kPolicyScreen{640, 400, 60};

// A pinhole at the height h sees what is `ahead` on the floor at f h / ahead below the horizon.
TEST(SeemingPlace, OfAPlanarPictureIsWhereTheObjectIs) {
  constexpr double kHeight = 1.6;
  const PixelRect view{100, 50, 640, 400};
  for (const double focal : {200.0, 500.0}) {
    for (const double ahead : {2.0, 9.0, 30.0}) {
      for (const double right : {-1.5, 0.0, 4.0}) {
        Sighting object;
        object.centroid = {view.center().x + focal * right / ahead, 0};
        object.upper.y = view.center().y + focal * kHeight / ahead;
        const SeemingPlace place = seemingPlace(object, view, focal, kHeight);
        EXPECT_NEAR(place.ahead, ahead, 1e-9 * ahead);
        EXPECT_NEAR(place.right, right, 1e-9 * ahead);
        EXPECT_NEAR(place.meters(), std::hypot(ahead, right), 1e-9 * ahead);
        EXPECT_NEAR(wrappedDegrees(place.degrees() - degreesFromRadians(std::atan2(right, ahead))), 0, 1e-9);
      }
    }
  }
  Sighting above;
  above.upper.y = view.top;
  EXPECT_NEAR(seemingPlace(above, view, 200, kHeight).ahead, kFarMeters, 1e-9);
}

TEST(SeemingFocal, IsThatOfThePicture) {
  const auto block =
      test::readBlock("distance", R"({"maze": "small", "start": {"row": 2, "column": 0, "heading": "east"},
      "cases": [{"row": 2, "column": 3}]})");
  const double truth = kPolicyScreen.width / 2.0 / std::tan(radiansFromDegrees(35));
  for (const TrialView view : kViews) {
    const auto run = block->start(test::planOf("distance", 0, view), kPolicyScreen);
    const Percept seen = VisibilitySensor(kPolicyScreen).look(run->layout(), true);
    // Patches are told by the means of a few rays.
    EXPECT_NEAR(seemingFocalPixels(seen).value() / truth, 1, 0.05);
    Percept without = seen;
    without.floor.clear();
    EXPECT_FALSE(seemingFocalPixels(without).has_value());
    without = seen;
    without.standing.reset();
    EXPECT_FALSE(seemingFocalPixels(without).has_value());
  }
}

/// What an observer that makes no errors of its own says.
EstimatedValue answerOf(const std::string& task, const TaskBlock& block, TrialView view, uint64_t seed) {
  HumanFactors factors;
  factors.slip = 0;
  factors.lengthErrorShare = 0;
  factors.pointingErrorDegrees = 0;
  const Vision vision(factors, 640 / 46.7);
  const Controls controls;
  const VisibilitySensor eye(kPolicyScreen);
  const auto run = block.start(test::planOf(task, 0, view), kPolicyScreen);
  const auto policy = taskKind(task, "test").policy({vision, controls, {}, seed});
  MotorModel motor(factors, controls, seed);
  int64_t now = 0;
  for (int i = 0; i < 20 && !run->outcome(); ++i, now += 300'000'000) {
    policy->think(eye.look(run->layout(), true), now, now + 300'000'000, motor);
    for (const TimedInput& input : motor.take(now + 300'000'000)) {
      run->handle(input.event);
    }
  }
  EXPECT_TRUE(run->outcome().has_value());
  const auto value = estimatedValue(run->outcome().value_or(TrialOutcome{}).measures);
  EXPECT_TRUE(value.has_value());
  return value.value_or(EstimatedValue{&estimateUnits().front(), 1, 1});
}

std::string caseJson(int column, double south) {
  return R"({"maze": "small", "answer_limit_seconds": 20, "start": {"row": 2, "column": 0, "heading": "east"},
      "cases": [{"row": 2, "column": )" +
         std::to_string(column) + R"(, "south": )" + std::to_string(south) + "}]}";
}

// At 15 m a pixel of this picture is 2 % of the distance; the focal length is good to 5 %, and a ball hides the point
// on which it stands.
TEST(EstimatePolicy, TellsFromAPlanarPictureHowFarAndWhichWay) {
  std::vector<double> lengths;
  for (const int column : {2, 3, 4, 5}) {
    const auto far = test::readBlock("distance", caseJson(column, 0));
    const EstimatedValue length = answerOf("distance", *far, TrialView::kReference, 5);
    EXPECT_LT(std::abs(length.signedError()), 0.12) << column << ": " << length.estimate;
    lengths.push_back(length.estimate);
    for (const double south : {-0.25, 0.25}) {
      const auto way = test::readBlock("direction", caseJson(column, south));
      const EstimatedValue direction = answerOf("direction", *way, TrialView::kReference, 5);
      EXPECT_LT(std::abs(direction.signedError()), 2) << column << ": " << direction.estimate;
    }
  }
  EXPECT_TRUE(std::is_sorted(lengths.begin(), lengths.end()));
}

TEST(EstimatePolicy, ErrsByTheFactorsOfTheSubject) {
  // 200 places of a subject whose factors are the usual ones: the deviation of the answers is that of the factor, with
  // a standard error of 5 %.
  const HumanFactors factors;
  const Vision vision(factors, 640 / 46.7);
  const Controls controls;
  const VisibilitySensor eye(kPolicyScreen);
  const auto block = test::readBlock("distance", caseJson(3, 0));
  const auto run = block->start(test::planOf("distance", 0, TrialView::kReference), kPolicyScreen);
  Percept seen = eye.look(run->layout(), true);
  double sum = 0;
  double squares = 0;
  constexpr int kSubjects = 200;
  for (uint64_t seed = 1; seed <= kSubjects; ++seed) {
    const auto policy = taskKind("distance", "test").policy({vision, controls, {}, seed});
    MotorModel motor(factors, controls, seed);
    const auto again = block->start(test::planOf("distance", 0, TrialView::kReference), kPolicyScreen);
    int64_t now = 0;
    for (int i = 0; i < 20 && !again->outcome(); ++i, now += 300'000'000) {
      policy->think(seen, now, now + 300'000'000, motor);
      for (const TimedInput& input : motor.take(now + 300'000'000)) {
        again->handle(input.event);
      }
    }
    ASSERT_TRUE(again->outcome().has_value());
    const double length = std::log(std::stod(again->outcome()->answer));
    sum += length;
    squares += length * length;
  }
  const double mean = sum / kSubjects;
  EXPECT_NEAR(std::sqrt(squares / kSubjects - mean * mean), factors.lengthErrorShare, 4 * 0.05 * 0.15);
}

}  // namespace
}  // namespace ocelli
