#include "oc_core/constructor/path_constructor.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/canyon.h"

namespace ocelli {
namespace {

PinholeCamera reference() {
  View view;
  view.fovVerticalDegrees = 30;
  view.zNear = 0.5f;
  view.zFar = 2000;
  return {view, 160, 90};
}

/// 100 m to the north, then 100 m to the north-east by so many degrees.
PathOptions corner(double degrees) {
  PathOptions options;
  const double angle = degrees * 3.14159265358979 / 180;
  options.path = {{0, 0, 0}, {0, 0, -100}};
  options.path.emplace_back(100 * std::sin(angle), 0, -100 - 100 * std::cos(angle));
  options.preview = 1;
  options.turns = 4;
  options.rounding = 0;
  return options;
}

TEST(PathCamera, raysFollowThePathAroundACorner) {
  const PathOptions options = corner(40);  // control points each 50 m, the second at the corner
  const CurvedRayCamera camera = buildPathCamera(options, {}, reference());
  ASSERT_EQ(camera.bends().size(), 1u);
  // All of the path is seen in the middle of the image, one half behind the other, but in the transition, where rays
  // cut the corner.
  for (const double along : {10.0, 50.0, 70.0, 130.0, 150.0, 199.0}) {
    const float beyond = static_cast<float>(std::max(along - 100, 0.0)) / 100;
    const glm::vec3 point =
        glm::mix(along < 100 ? glm::vec3(0, 0, -static_cast<float>(along)) : options.path[1], options.path[2], beyond);
    const auto seen = camera.project(point);
    ASSERT_TRUE(seen) << along;
    EXPECT_NEAR(seen->u, 80, 0.01) << along;
    EXPECT_NEAR(seen->v, 45, 0.01) << along;
  }
}

TEST(PathCamera, isThePinholeOnAStraightPath) {
  const CurvedRayCamera camera = buildPathCamera(corner(0), {}, reference());
  EXPECT_TRUE(camera.bends().empty());
}

TEST(PathCamera, theRootLooksAlongThePathFromItsHeight) {
  PathOptions options = corner(40);
  options.position = 0.25;
  options.eyeHeight = 5;
  options.preview = 0.5;
  const PinholeCamera root = pathPinhole(options, {}, reference());
  EXPECT_LT(glm::distance(root.eye(), glm::vec3(0, 5, -50)), 1e-4f);
  EXPECT_LT(glm::distance(root.forward(), glm::vec3(0, 0, -1)), 1e-5f);
  EXPECT_EQ(root.view().fovVerticalDegrees, 30);
}

TEST(PathCamera, turnsUnfoldAndCollapse) {
  PathOptions options = corner(40);
  options.preview = 0.8;
  const auto end = [](const CurvedRayCamera& camera) {
    const RayPath ray = camera.rayPath({80, 45});
    return glm::normalize(ray.back() - ray[ray.size() - 2]);
  };
  float most = 0;
  glm::vec3 last = end(buildPathCamera(options, {}, reference()));
  for (options.position = 0; options.position < 0.9; options.position += 0.001) {
    const CurvedRayCamera camera = buildPathCamera(options, {}, reference());
    // 40 degrees come in over 80 m, and the view turns by them over 40; smoothly, at most 1.5 times as fast as evenly:
    // 0.3 degrees a step of 0.2 m.
    EXPECT_LT(glm::distance(end(camera), last), 0.01f) << options.position;
    last = end(camera);
    most = std::max(most, glm::distance(last, camera.root().forward()));
  }
  EXPECT_GT(most, 0.34f);  // the control points cut the corner in turns of 20 degrees; one of them is made in full
  EXPECT_TRUE(buildPathCamera(options, {}, reference()).bends().empty());
}

TEST(PathCamera, cornersAreRounded) {
  PathOptions options = corner(90);  // 100 m to the north, then to the east
  options.rounding = 1;              // over 50 m
  const auto eyeAt = [&](double position) {
    options.position = position;
    return pathPinhole(options, {}, reference()).eye();
  };
  EXPECT_LT(glm::distance(eyeAt(0.3), glm::vec3(0, 0, -60)), 1e-4f);  // 40 m before the corner
  // At the corner: of 25 m on either side, the mean is a quarter of 25 m off along both.
  EXPECT_LT(glm::distance(eyeAt(0.5), glm::vec3(6.25f, 0, -93.75f)), 1e-4f);
  // 10 m before it: 35 m of the first leg, whose mean is 17.5 m before the corner, and 15 m of the other.
  EXPECT_LT(glm::distance(eyeAt(0.45), glm::vec3(7.5f * 0.3f, 0, -100 + 17.5f * 0.7f)), 1e-4f);
  EXPECT_LT(glm::distance(eyeAt(0), glm::vec3(0, 0, 0)), 1e-4f);  // it goes straight on beyond its ends
  options.rounding = 0;
  EXPECT_LT(glm::distance(eyeAt(0.5), glm::vec3(0, 0, -100)), 1e-4f);
}

TEST(PathCamera, takesAnyPath) {
  Random random(4);
  size_t turns = 0;
  for (int i = 0; i < 300; ++i) {
    PathOptions options;
    const size_t count = 2 + random.below(30);
    for (size_t k = 0; k < count; ++k) {
      const float x = random.inRange(-50, 50);
      const float y = random.inRange(-20, 20);
      options.path.emplace_back(x, y, random.inRange(-50, 50));
    }
    options.position = random.inRange(0, 1);
    options.preview = random.inRange(0.01f, 1);
    options.turns = 1 + static_cast<int>(random.below(16));
    turns += buildPathCamera(options, {}, reference()).bends().size();
  }
  EXPECT_GT(turns, 100u);
}

TEST(PathCamera, goesAlongRivers) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SceneGuides guides;
    guides.path = canyonPath(seed);
    PathOptions options;
    for (const int turns : {1, 3, 8}) {
      options.turns = turns;
      for (options.position = 0; options.position <= 1; options.position += 0.04) {
        EXPECT_NO_THROW(buildPathCamera(options, guides, reference())) << seed << " " << options.position;
      }
    }
  }
}

TEST(PathCamera, pointsThatDoNotLengthenThePathAreLeftOut) {
  // The last two points differ by less than the length of the path so far can say.
  PathOptions options;
  options.path = {{-1e17f, 0, 0}, {0, 0, 0}, {0, 0, -1}};
  options.position = 1;
  PathOptions without = options;
  without.path.pop_back();
  const glm::vec3 eye = pathPinhole(options, {}, reference()).eye();
  EXPECT_TRUE(std::isfinite(eye.x) && std::isfinite(eye.y) && std::isfinite(eye.z));
  EXPECT_EQ(eye, pathPinhole(without, {}, reference()).eye());
}

TEST(PathCamera, aPathWithoutALengthIsRefused) {
  EXPECT_THROW(buildPathCamera({}, {}, reference()), InputError);
  PathOptions options;
  options.path = {{1, 2, 3}};
  EXPECT_THROW(buildPathCamera(options, {}, reference()), InputError);
  options.path = {{1, 2, 3}, {1, 2, 3}};
  EXPECT_THROW(buildPathCamera(options, {}, reference()), InputError);
  options.path = {{1, 2, 3}, {std::nanf(""), 2, 3}};
  EXPECT_THROW(buildPathCamera(options, {}, reference()), InputError);
}

}  // namespace
}  // namespace ocelli
