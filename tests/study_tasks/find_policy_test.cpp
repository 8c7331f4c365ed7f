#include "study/tasks/find_policy.h"

#include <gtest/gtest.h>

#include "study/agent/visibility_sensor.h"
#include "tests/study_task/study_tasks.h"

namespace ocelli {
namespace {

constexpr int64_t kSecond = 1'000'000'000;
constexpr TrialScreen kScreen{200, 125, 60};

struct Found {
  TrialOutcome outcome;
  double meters = 0;
  bool clicked = false;
  bool operator==(const Found&) const = default;
};

/// A trial with one fixation after the other, 60 frames a second.
Found find(const std::string& more, TrialView view, const StudyRenderer& renderer, uint64_t seed = 3) {
  std::string json = R"({"maze": "small", "limit_seconds": 40, )";
  json += more;
  json += "}";
  const auto block = test::readBlock("find", json);
  const auto run = block->start(test::planOf("find", 0, view), kScreen);
  const VisibilitySensor eye(kScreen, renderer);
  const HumanFactors factors;
  MazeMemory memory;
  FindPolicy policy(Vision(factors, kScreen.width / 46.7), Controls{}, memory, seed);
  MotorModel motor(factors, Controls{}, seed);
  Found found;
  int64_t nextLook = 0;
  int64_t tick = 0;
  for (int64_t frame = 0; !run->outcome(); ++frame) {
    const int64_t now = frame * kSecond / 60;
    if (now >= nextLook) {
      nextLook = now + 3 * kSecond / 10;
      policy.think(eye.look(run->layout(), true), now, nextLook, motor);
    }
    for (const TimedInput& input : motor.take(now + kSecond / 60)) {
      found.clicked = found.clicked || std::holds_alternative<PointerButtonEvent>(input.event);
      run->handle(input.event);
    }
    for (; tick < (frame + 1) * kTicksPerSecond / 60; ++tick) {
      run->advance();
    }
  }
  found.outcome = *run->outcome();
  for (const auto& [name, value] : found.outcome.measures) {
    found.meters = name == "path_length_m" ? value : found.meters;
  }
  return found;
}

const std::string kAround = R"("cases": [{"row": 2, "column": 4}])";

TEST(FindPolicy, walksToWhatItCannotSeeFromTheStartAndClicksOnIt) {
  for (const TrialView view : kViews) {
    const Found found = find(kAround, view, rasterizeStudy);
    EXPECT_TRUE(found.outcome.correct) << defaultConditions().nameOf(view);
    EXPECT_LT(found.outcome.responseTicks, 40 * kTicksPerSecond);
    EXPECT_GT(found.meters, 1) << "it is not in sight at first";
  }
}

TEST(FindPolicy, clicksWhereItStandsOnWhatIsInSight) {
  const Found found = find(R"("cases": [{"row": 2, "column": 3}], "start": {"row": 2, "column": 0, "heading": "east"})",
                           TrialView::kReference, rasterizeStudy);
  EXPECT_TRUE(found.outcome.correct);
  EXPECT_LT(found.outcome.responseTicks, 6 * kTicksPerSecond);
  EXPECT_LT(found.meters, 3);
}

TEST(FindPolicy, doesTheSameAgain) {
  EXPECT_EQ(find(kAround, TrialView::kOther, rasterizeStudy), find(kAround, TrialView::kOther, rasterizeStudy));
  EXPECT_NE(find(kAround, TrialView::kOther, rasterizeStudy, 1), find(kAround, TrialView::kOther, rasterizeStudy, 2));
}

TEST(FindPolicy, neverFindsWhatItIsNotShown) {
  const StudyRenderer black = [](const StudyCamera& camera, const Mesh&) {
    return std::visit([](const auto& each) { return FragmentImage(each.width(), each.height()); }, camera);
  };
  const Found found = find(kAround, TrialView::kReference, black);
  EXPECT_TRUE(found.outcome.censored);
  EXPECT_EQ(found.meters, 0) << "it knows no way";
}

TEST(FindPolicy, doesNotFindAnObjectThatIsLeftOutOfWhatItIsShown) {
  // The structure alone: it searches all of the maze, and clicks nowhere.
  const StudyRenderer bare = [](const StudyCamera& camera, const Mesh& mesh) {
    Mesh structure = mesh;
    for (size_t v = 0; v < structure.positions.size(); ++v) {
      // Grey is structure: see StudyScene. Objects have colours.
      const glm::vec3 color = mesh.colors[v];
      if (std::abs(color.x - color.y) > 0.01f || std::abs(color.y - color.z) > 0.01f) {
        structure.positions[v].y -= 100;
      }
    }
    return rasterizeStudy(camera, structure);
  };
  const Found found = find(kAround, TrialView::kReference, bare);
  EXPECT_TRUE(found.outcome.censored);
  EXPECT_GT(found.meters, 30);
}

/// The sought ball in the middle of the view, seen from (4.5, 4.5).
Percept soughtInSight(double headingRadians) {
  Percept seen;
  seen.views = {{0, 0, 400, 300}};
  seen.grid = {{0, 0}, 3, 1};
  seen.standing = WalkerPose{4.5, 4.5, headingRadians};
  seen.soughtShape = LandmarkShape::kSphere;
  seen.soughtColor = LandmarkColor::kOrange;
  seen.objects = {{.shape = LandmarkShape::kSphere,
                   .color = LandmarkColor::kOrange,
                   .pixels = 900,
                   .lower = {180, 130},
                   .upper = {210, 160},
                   .centroid = {195, 145},
                   .aim = {195, 145},
                   .place = {5, -3}}};
  return seen;
}

TEST(FindPolicy, learnsWhetherThingsMoveBySeeingThem) {
  const HumanFactors factors;
  MazeMemory memory;
  MotorModel motor(factors, Controls{}, 1);
  Percept seen = soughtInSight(0);
  const auto watch = [&](double metersPerSecond) {
    FindPolicy policy(Vision(factors, 20), Controls{}, memory, 1);
    for (int64_t now = 0; now < 2 * kSecond; now += 3 * kSecond / 10) {
      seen.objects[0].place.x = 5 + metersPerSecond * secondsOf(now);
      policy.think(seen, now, now + 3 * kSecond / 10, motor);
    }
  };
  EXPECT_FALSE(memory.soughtMoves());
  watch(0.8);
  EXPECT_TRUE(memory.soughtMoves());
  Random random(1);
  memory.beginTrial(0, random);
  EXPECT_TRUE(memory.soughtMoves()) << "what was seen in one trial is expected in the next";
  watch(0);
  EXPECT_FALSE(memory.soughtMoves());
}

TEST(FindPolicy, turnsBackToWhatItCaughtAGlimpseOf) {
  const HumanFactors factors;
  MazeMemory memory;
  FindPolicy policy(Vision(factors, 20), Controls{}, memory, 1);
  MotorModel motor(factors, Controls{}, 1);
  constexpr int64_t kFixation = kSecond / 10;
  static_assert(kFixation < 2 * kSecond / 10);  // shorter than it takes to make something out
  const Percept glimpse = soughtInSight(0.2);
  Percept gone = glimpse;
  gone.objects.clear();
  gone.standing = WalkerPose{4.5, 4.5, 1.3};
  policy.think(glimpse, 0, kFixation, motor);
  policy.think(gone, kFixation, 2 * kFixation, motor);
  policy.think(gone, 5 * kFixation, 6 * kFixation, motor);
  const WalkerPose turned = motor.reckon(*gone.standing, 5 * kFixation, 20 * kFixation);
  EXPECT_NEAR(turned.headingRadians, 0.2, 0.4);
  EXPECT_NEAR(turned.x, 4.5, 0.1);
  EXPECT_NEAR(turned.z, 4.5, 0.1);
}

}  // namespace
}  // namespace ocelli
