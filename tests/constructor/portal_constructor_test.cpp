#include "oc_core/constructor/portal_constructor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/town_plan.h"
#include "tests/constructor/random_walk.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

/// A door of 1 m x 2 m in the plane x = 0 that one enters towards -x.
Portal door(const glm::vec3& center = {0, 1, 0}) {
  return {center, {1, 0, 0}, {0, 0, -0.5f}, {0, 1, 0}};
}

/// The eye at (x, 1.5, z), looking level towards (0, 1.5, 0).
PinholeCamera lookingIn(float x, float z) {
  View view = test::viewAt({x, 1.5f, z}, glm::normalize(glm::vec2(-x, -z)));
  return {view, 160, 90};
}

SceneGuides withPortals(const std::vector<Portal>& portals) {
  SceneGuides guides;
  guides.portals = portals;
  return guides;
}

std::string errorOf(const PortalOptions& options, const SceneGuides& guides, const PinholeCamera& camera) {
  try {
    buildPortalCamera(options, guides, camera);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PortalPresence, isFullFromTheSideAtMiddleDistance) {
  for (const PortalCurve& curve : portalCurves()) {
    EXPECT_DOUBLE_EQ(portalPresence(door(), {1.5, 1.5, 5}, curve.options), 1);  // 73 degrees aside, 4.7 m away
  }
}

TEST(PortalPresence, isNoneWhereRaysMustGoStraight) {
  for (const PortalCurve& curve : portalCurves()) {
    const auto presence = [&](const glm::dvec3& eye) { return portalPresence(door(), eye, curve.options); };
    EXPECT_EQ(presence({-1, 1.5, 3}), 0);      // behind it
    EXPECT_EQ(presence({0, 1.5, 3}), 0);       // edge on
    EXPECT_EQ(presence({0.001, 1.5, 3}), 0);   // nearly so
    EXPECT_EQ(presence({3, 1.5, 0}), 0);       // before it
    EXPECT_EQ(presence({0.05, 1.5, 0.4}), 0);  // in the doorway
  }
}

TEST(PortalPresence, theBandEndsFarAwayAndTheUsualCurveDoesNot) {
  EXPECT_EQ(portalPresence(door(), {4, 1.5, 13}, portalCurve("band")), 0);
  EXPECT_EQ(portalPresence(door(), {0.01, 1.5, 3}, portalCurve("band")), 0);  // 0.2 degrees before edge on
  for (double away = 3.5; away < 1e5; away *= 1.5) {
    EXPECT_EQ(portalPresence(door(), {0.3 * away, 1.5, away}), 1) << away;  // 73 degrees aside
  }
}

/// The presence as it first stood, word by word.
double firstPresence(const Portal& portal, const glm::dvec3& eye) {
  const glm::dvec3 offset = eye - glm::dvec3(portal.center);
  const glm::dvec3 p(glm::dot(offset, glm::normalize(glm::dvec3(portal.halfRight))),
                     glm::dot(offset, glm::normalize(glm::dvec3(portal.halfUp))),
                     glm::dot(offset, glm::dvec3(portal.normal)));
  if (!(p.z > 0)) {
    return 0;
  }
  const glm::dvec2 half(glm::length(portal.halfRight), glm::length(portal.halfUp));
  const glm::dvec2 beside = glm::max(glm::abs(glm::dvec2(p)) - half, 0.0);
  const double distance = glm::length(glm::dvec3(beside, p.z)) / (2 * std::min(half.x, half.y));
  const double degrees = degreesFromRadians(std::atan2(std::abs(p.x), p.z));
  return glm::smoothstep(0.1, 3.0, distance) * (1 - glm::smoothstep(0.75 * 12, 12.0, distance)) *
         glm::smoothstep(5.0, 65.0, degrees) * (1 - glm::smoothstep(87.0 - 4, 87.0, degrees));
}

TEST(PortalPresence, theBandIsBitByBitWhatItWas) {
  // Stored trials of studies replay with it.
  Random random(5);
  const PortalOptions& band = portalCurve("band");
  EXPECT_EQ(band.handOver, 0.5);
  size_t between = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 eye(random.inRange(-1, 13), random.inRange(0, 3), random.inRange(-13, 13));
    const double presence = portalPresence(door(), eye, band);
    EXPECT_EQ(presence, firstPresence(door(), eye));
    between += presence > 0 && presence < 1;
  }
  EXPECT_GT(between, 5000u);
}

TEST(PortalPresence, changesSmoothly) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.inRange(-1, 13);
    const double z = random.inRange(-13, 13);
    const glm::dvec3 eye(x, random.inRange(0, 3), z);
    const glm::dvec3 near = eye + glm::dvec3(random.inRange(-1e-6f, 1e-6f), 0, random.inRange(-1e-6f, 1e-6f));
    for (const PortalCurve& curve : portalCurves()) {
      // The steepest slope is that before a portal is edge on, 1.5 over the degrees of its fade; where it is bent,
      // more than 0.8 m from the middle, that is 27 a metre over 4 degrees and 270 over 0.4.
      EXPECT_NEAR(portalPresence(door(), eye, curve.options), portalPresence(door(), near, curve.options), 5e-4);
    }
  }
}

TEST(PortalViewpoint, turnsAboutTheMiddleAtItsHeight) {
  const glm::dvec3 eye(3, 1.5, 4);
  EXPECT_LT(glm::distance(portalViewpoint(door(), eye, 0), eye), 1e-12);
  EXPECT_LT(glm::distance(portalViewpoint(door(), eye, 1), glm::dvec3(5, 1.5, 0)), 1e-12);
  for (const double share : {0.2, 0.7}) {
    const glm::dvec3 viewpoint = portalViewpoint(door(), eye, share);
    EXPECT_NEAR(std::hypot(viewpoint.x, viewpoint.z), 5, 1e-12);
    EXPECT_DOUBLE_EQ(viewpoint.y, 1.5);
  }
}

TEST(PortalCamera, looksAlongTheNormal) {
  const PinholeCamera reference = lookingIn(1.5f, 5);
  const GraphCamera camera = buildPortalCamera({}, withPortals({door()}), reference);
  ASSERT_EQ(camera.frusta().size(), 2u);
  // The ray through the middle of the door, at the height of the eye, goes on along -x.
  const RayPath path = camera.rayPath({80, 45});
  ASSERT_EQ(path.size(), 3u);
  EXPECT_LT(glm::distance(path[1], glm::vec3(0, 1.5f, 0)), 1e-4f);
  EXPECT_LT(glm::distance(glm::normalize(path[2] - path[1]), glm::vec3(-1, 0, 0)), 1e-5f);
  // 3 m behind the door: as far as the eye is from it, and 3 m.
  const auto behind = camera.unproject({80, 45, std::hypot(1.5f, 5.0f) + 3});
  ASSERT_TRUE(behind);
  EXPECT_LT(glm::distance(*behind, glm::vec3(-3, 1.5f, 0)), 1e-4f);
}

TEST(PortalCamera, isThePinholeBeforeAndBesideThePortal) {
  const PinholeCamera reference = lookingIn(1.5f, 5);
  const GraphCamera camera = buildPortalCamera({}, withPortals({door()}), reference);
  for (const glm::vec3& point : {glm::vec3(0.1f, 1.5f, 0.2f), glm::vec3(0.2f, 0.5f, -3), glm::vec3(-0.5f, 2.6f, 0)}) {
    const auto mine = camera.project(point);
    const auto theirs = reference.project(point);
    ASSERT_TRUE(mine && theirs);
    EXPECT_NEAR(mine->u, theirs->u, 1e-3);
    EXPECT_NEAR(mine->v, theirs->v, 1e-3);
  }
}

TEST(PortalCamera, leavesOutWhatIsNotInView) {
  View away = test::viewAt({1.5f, 1.5f, 5}, {1, 0});
  EXPECT_EQ(buildPortalCamera({}, withPortals({door()}), {away, 160, 90}).frusta().size(), 1u);
  EXPECT_EQ(buildPortalCamera({}, withPortals({door()}), lookingIn(-2, 5)).frusta().size(), 1u);
}

/// The portal that a ray of the pinhole passes first, found one by one.
int firstOnRay(const std::vector<Portal>& portals, const PinholeCamera& camera, const glm::vec2& pixel) {
  const RayPath ray = camera.rayPath(pixel);
  const glm::vec3 direction = ray[1] - ray[0];
  int first = -1;
  float nearest = 2;
  for (size_t i = 0; i < portals.size(); ++i) {
    const Portal& portal = portals[i];
    const float along = glm::dot(portal.center - ray[0], portal.normal) / glm::dot(direction, portal.normal);
    const glm::vec3 offset = ray[0] + direction * along - portal.center;
    const bool inside = std::abs(glm::dot(offset, portal.halfRight)) < glm::dot(portal.halfRight, portal.halfRight) &&
                        std::abs(glm::dot(offset, portal.halfUp)) < glm::dot(portal.halfUp, portal.halfUp);
    if (inside && along > 0 && along < nearest) {
      nearest = along;
      first = static_cast<int>(i);
    }
  }
  return first;
}

TEST(PortalCamera, theNearerPortalKeepsItsPart) {
  // Three doors one behind the other, which overlap in the image, all fully present.
  const std::vector<Portal> doors{door({-1.2f, 1, -1.5f}), door(), door({-0.6f, 1.2f, -0.8f})};
  const PinholeCamera reference = lookingIn(1.5f, 5);
  for (const Portal& each : doors) {
    ASSERT_EQ(portalPresence(each, glm::dvec3(reference.eye())), 1);
  }
  const GraphCamera camera = buildPortalCamera({}, withPortals(doors), reference);
  size_t behind = 0;
  for (float v = 0.5f; v < 90; ++v) {
    for (float u = 0.5f; u < 160; ++u) {
      const int child = camera.childAt(GraphCamera::kRoot, {u, v});
      const int first = firstOnRay(doors, reference, {u, v});
      EXPECT_EQ(child < 0 ? "none" : camera.frusta()[static_cast<size_t>(child)].name,
                first < 0 ? "none" : "portal " + std::to_string(first + 1))
          << u << ", " << v;
      behind += first == 0 || first == 2;
    }
  }
  EXPECT_GT(behind, 20u);
}

/// The one frustum of that name, if there is one.
const GraphCamera::Frustum* find(const GraphCamera& camera, const std::string& name) {
  const auto found = std::find_if(camera.frusta().begin(), camera.frusta().end(),
                                  [&](const GraphCamera::Frustum& each) { return each.name == name; });
  return found == camera.frusta().end() ? nullptr : &*found;
}

TEST(PortalCamera, whatIsBehindALeavingPortalComesIn) {
  // Behind a large opening there is a door aside, which is seen through it alone.
  const Portal opening{{0, 1, 0}, {1, 0, 0}, {0, 0, -3}, {0, 3, 0}};
  const Portal aside{{-5, 1, -1}, {0, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}};
  PortalOptions options = portalCurve("band");
  options.straightDegrees = 0;
  options.bentBeyond = 0.5;
  options.bentDegrees = 10;
  const auto camera = [&](float x) {
    return buildPortalCamera(options, withPortals({opening, aside}),
                             {test::viewAt({x, 1.5f, 1}, {-1, -0.3f}), 160, 90});
  };
  size_t held = 0;
  size_t shared = 0;
  size_t free = 0;
  for (float x = 0.05f; x < 3.5f; x += 0.05f) {
    const glm::dvec3 eye(x, 1.5f, 1);
    const double presence = portalPresence(opening, eye, options);
    const GraphCamera built = camera(x);
    const GraphCamera::Frustum* turned = find(built, "portal 2");
    ASSERT_EQ(portalPresence(aside, eye, options), 1) << x;
    EXPECT_EQ(find(built, "portal 1") != nullptr, presence > 0.5) << x;
    if (presence >= 0.5) {
      ++held;
      EXPECT_EQ(turned, nullptr) << x;
    } else {
      ++(presence > 0 ? shared : free);
      ASSERT_NE(turned, nullptr) << x;
      EXPECT_LT(glm::distance(turned->viewpoint, portalViewpoint(aside, eye, 1 - 2 * presence)), 1e-9) << x;
    }
  }
  EXPECT_GT(held, 0u);
  EXPECT_GT(shared, 0u);
  EXPECT_GT(free, 0u);
}

TEST(PortalCamera, namedPortalsMustFaceTheEye) {
  PortalOptions options;
  options.portals = {door(), door()};
  EXPECT_EQ(errorOf(options, {}, lookingIn(1.5f, 5)), "");
  options.portals[1].normal = -options.portals[1].normal;
  EXPECT_THAT(errorOf(options, {}, lookingIn(1.5f, 5)), HasSubstr("portal 2: the eye is behind"));
  options.portals[1] = door({1.5f, 1, 0});
  EXPECT_THAT(errorOf(options, {}, lookingIn(1.5f, 5)), HasSubstr("portal 2: the eye sees a portal edge on"));
}

TEST(PortalCamera, aSceneWithoutPortalsAndAnEyeInAWallAreRefused) {
  EXPECT_THAT(errorOf({}, {}, lookingIn(1.5f, 5)), HasSubstr("no portals"));
  SceneGuides guides;
  guides.maze = Maze(3, 3);
  EXPECT_THAT(errorOf({}, guides, {test::viewAt({3, 1.5f, 1.5f}, {1, 0}), 160, 90}), HasSubstr("in a wall"));
}

TEST(PortalCamera, mazesAndTownsAreTakenFromEverywhere) {
  Random random(2);
  SceneGuides town;
  town.portals = townPortals();
  size_t frusta = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    MazeOptions options;
    options.seed = seed;
    SceneGuides maze;
    maze.maze = generateMaze(options);
    for (int i = 0; i < 30; ++i) {
      const float x = random.inRange(0, 21);
      const glm::vec3 eye(x, 1.5f, random.inRange(0, 21));
      const float angle = random.inRange(0, 6.28f);
      const View view = test::viewAt(eye, {std::cos(angle), std::sin(angle)});
      if (!maze.maze->isInWall(eye)) {
        frusta += buildPortalCamera({}, maze, {view, 160, 90}).frusta().size() - 1;
      }
      View inTown = view;
      inTown.eye = (eye - glm::vec3(10.5f, 0, 10.5f)) * glm::vec3(4, 1, 3);
      inTown.target = inTown.eye + (view.target - view.eye);
      frusta += buildPortalCamera({}, town, {inTown, 160, 90}).frusta().size() - 1;
    }
  }
  EXPECT_GT(frusta, 500u);
}

}  // namespace
}  // namespace ocelli
