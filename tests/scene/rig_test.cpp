#include "oc_core/scene/rig.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr float kHalfTurn = 0.70710678f;  // sin and cos of 45 degrees: half of a quaternion that turns by 90

RigChannel channel(RigTarget target, std::vector<float> times, std::vector<float> values, bool steps = false) {
  const auto width = static_cast<uint32_t>(values.size() / times.size());
  return {0, target, steps, width, std::move(times), std::move(values)};
}

void expectMovedTo(const glm::vec3& a, const glm::vec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-5f) << a.x << " " << a.y << " " << a.z;  // some roundings of single precision
}

TEST(RigChannel, RunsStraightBetweenItsKeysAndStaysBeyondThem) {
  const RigChannel moves = channel(RigTarget::kPosition, {1, 3}, {0, 0, 0, 4, 8, -4});
  std::array<float, 3> v{};
  for (const auto& [seconds, x] :
       std::vector<std::pair<double, float>>{{0, 0}, {1, 0}, {1.5, 1}, {2, 2}, {3, 4}, {9, 4}}) {
    sample(moves, seconds, v.data());
    EXPECT_FLOAT_EQ(v[0], x) << seconds;
    EXPECT_FLOAT_EQ(v[1], 2 * x) << seconds;
    EXPECT_FLOAT_EQ(v[2], -x) << seconds;
  }
}

TEST(RigChannel, StepsAtItsKeys) {
  const RigChannel jumps = channel(RigTarget::kWeights, {0, 1, 2}, {5, 6, 7}, true);
  float v = 0;
  for (const auto& [seconds, value] :
       std::vector<std::pair<double, float>>{{0, 5}, {0.99, 5}, {1, 6}, {1.5, 6}, {2, 7}, {3, 7}}) {
    sample(jumps, seconds, &v);
    EXPECT_EQ(v, value) << seconds;
  }
}

// Two keys two seconds apart with tangents that a cubic polynomial has there: it is met everywhere.
TEST(RigChannel, FollowsCubicSplines) {
  const auto cubic = [](double t) { return 0.5 * t * t * t - 2 * t * t + 3 * t - 1; };
  const auto slope = [](double t) { return 1.5 * t * t - 4 * t + 3; };
  RigChannel moves = channel(RigTarget::kWeights, {1, 3, 3.5f}, {0, 0, 0});
  moves.values.clear();
  for (const float time : moves.times) {
    moves.values.push_back(static_cast<float>(cubic(static_cast<double>(time))));
    moves.tangents.insert(moves.tangents.end(), 2, static_cast<float>(slope(static_cast<double>(time))));
  }
  float v = 0;
  for (double t = 1; t <= 3.5; t += 0.03125) {
    sample(moves, t, &v);
    EXPECT_NEAR(v, cubic(t), 1e-5) << t;  // some roundings of single precision
  }
  sample(moves, 0, &v);
  EXPECT_FLOAT_EQ(v, static_cast<float>(cubic(1))) << "it stays before the first key";
  sample(moves, 9, &v);
  EXPECT_FLOAT_EQ(v, static_cast<float>(cubic(3.5))) << "and after the last one";
}

// The tangents before and after a key may differ, and rotations are made unit quaternions.
TEST(RigChannel, HasATangentBeforeAndOneAfterEachKey) {
  RigChannel moves = channel(RigTarget::kWeights, {0, 1, 2}, {0, 0, 0});
  moves.tangents = {9, 1, 0, -2, 0, 9};
  float v = 0;
  sample(moves, 0.5, &v);
  EXPECT_FLOAT_EQ(v, 0.125f) << "from 1 to 0";
  sample(moves, 1.5, &v);
  EXPECT_FLOAT_EQ(v, -0.25f) << "from -2 to 0";
  RigChannel turns = channel(RigTarget::kRotation, {0, 1}, {0, 0, 0, 1, 0, 0, kHalfTurn, kHalfTurn});
  turns.tangents.assign(16, 0);
  Rig rig;
  rig.nodes.resize(1);
  const glm::mat4 half = worldFromNodes(rig, RigAnimation{"", {turns}}, 0.5)[0];
  expectMovedTo(glm::vec3(half * glm::vec4(1, 0, 0, 1)), {kHalfTurn, kHalfTurn, 0});
}

// From no turn to a quarter about z; half of the time is half of the angle, and the shorter way is taken where the
// quaternion has the other sign.
TEST(RigChannel, TurnsAtAConstantRate) {
  for (const float sign : {1.0f, -1.0f}) {
    const RigChannel turns =
        channel(RigTarget::kRotation, {0, 2}, {0, 0, 0, 1, 0, 0, sign * kHalfTurn, sign * kHalfTurn});
    Rig rig;
    rig.nodes.resize(1);
    const RigAnimation animation{"", {turns}};
    const glm::mat4 half = worldFromNodes(rig, animation, 1)[0];
    expectMovedTo(glm::vec3(half * glm::vec4(1, 0, 0, 1)), {kHalfTurn, kHalfTurn, 0});
    expectMovedTo(glm::vec3(worldFromNodes(rig, animation, 5)[0] * glm::vec4(1, 0, 0, 1)), {0, 1, 0});
  }
}

TEST(RigNodes, AreMovedWithTheirParents) {
  Rig rig;
  rig.nodes = {{kNoRigParent, glm::translate(glm::mat4(1), glm::vec3(1, 0, 0))},
               {0, glm::translate(glm::mat4(1), glm::vec3(0, 2, 0))}};
  RigAnimation animation{"", {channel(RigTarget::kRotation, {0}, {0, 0, kHalfTurn, kHalfTurn})}};
  // The root has a channel: it stands by that alone, at the origin.
  expectMovedTo(glm::vec3(worldFromNodes(rig, animation, 0)[1] * glm::vec4(0, 0, 0, 1)), {-2, 0, 0});
  animation.channels.push_back(channel(RigTarget::kPosition, {0, 1}, {0, 0, 0, 0, 0, 6}));
  animation.channels.push_back(channel(RigTarget::kScale, {0}, {2, 2, 2}));
  // Scale, then rotation, then position.
  expectMovedTo(glm::vec3(worldFromNodes(rig, animation, 0.5)[1] * glm::vec4(0, 1, 0, 1)), {-6, 0, 3});
  EXPECT_EQ(animation.seconds(), 1);
}

TEST(Skin, IsTheWeightedSumOfWhatItsBonesDo) {
  RigPart part;
  part.bones = {{0, glm::mat4(1)}, {1, glm::translate(glm::mat4(1), glm::vec3(0, -1, 0))}};
  part.first = {0, 1, 3, 4, 4};
  part.weights = {{0, 1}, {0, 0.5f}, {1, 0.5f}, {1, 1}};
  const std::vector<glm::mat4> worldFromNode{
      glm::mat4(1),
      glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0, 1, 0)), static_cast<float>(kPi / 2), glm::vec3(0, 0, 1))};
  const std::vector<glm::vec3> bound{{0, 2, 0}, {0, 2, 0}, {0, 2, 0}, {0, 2, 0}};
  std::vector<glm::vec3> moved;
  skin(part, bound, worldFromNode, glm::translate(glm::mat4(1), glm::vec3(0, 0, 9)), {}, moved);
  ASSERT_EQ(moved.size(), 4u);
  expectMovedTo(moved[0], {0, 2, 0});         // by the bone that stands still
  expectMovedTo(moved[2], {-1, 1, 0});        // by the one that turns about (0, 1, 0) by a right angle
  expectMovedTo(moved[1], {-0.5f, 1.5f, 0});  // half and half
  expectMovedTo(moved[3], {0, 2, 9});         // by no bone: by its node
}

TEST(Skin, MorphsBeforeItMoves) {
  RigPart part;
  part.morphs = {{{{1, 0, 0}}, 0}, {{{0, 0, 2}}, 0}};
  std::vector<glm::vec3> moved;
  skin(part, {{0, 1, 0}}, {}, glm::scale(glm::mat4(1), glm::vec3(10)), {0.5f, 0.25f}, moved);
  expectMovedTo(moved[0], {5, 10, 5});
}

}  // namespace
}  // namespace ocelli
