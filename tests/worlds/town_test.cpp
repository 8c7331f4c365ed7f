#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/town_house.h"
#include "oc_core/worlds/town_plan.h"
#include "oc_core/worlds/town_things.h"
#include "oc_core/worlds/wall_slab.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

/// Whether a triangle meets the segment from a to b.
bool isBlocked(const Mesh& mesh, const glm::vec3& a, const glm::vec3& b) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
    const glm::dvec3 p(mesh.positions[t.x]);
    const glm::dvec3 u = glm::dvec3(mesh.positions[t.y]) - p;
    const glm::dvec3 v = glm::dvec3(mesh.positions[t.z]) - p;
    const glm::dvec3 along = glm::dvec3(b) - glm::dvec3(a);
    const glm::dvec3 normal = glm::cross(u, v);
    const double slant = -glm::dot(along, normal);
    if (std::abs(slant) < 1e-12) {
      return false;
    }
    const glm::dvec3 from = glm::dvec3(a) - p;
    const double where = glm::dot(from, normal) / slant;
    const glm::dvec3 moment = glm::cross(from, along);
    const double s = glm::dot(v, moment) / slant;
    const double r = -glm::dot(u, moment) / slant;
    return where >= 0 && where <= 1 && s >= 0 && r >= 0 && s + r <= 1;
  });
}

TEST(WallSlab, IsClosedAndLacksItsOpenings) {
  WallSlab slab;
  slab.xs = {0, 1, 3, 4};
  slab.ys = {0, 2, 3};
  slab.thickness = 0.5f;
  slab.color = [](size_t, size_t) { return glm::vec3(1); };
  Mesh whole;
  addSlab(whole, slab, glm::mat4(1));
  EXPECT_TRUE(isClosed(whole));
  EXPECT_DOUBLE_EQ(signedVolume(whole), 6.0);
  slab.isOpen = [](size_t i, size_t j) { return i == 1 && j == 0; };  // a door of 2 x 2
  Mesh door;
  addSlab(door, slab, glm::mat4(1));
  EXPECT_TRUE(isClosed(door));
  EXPECT_DOUBLE_EQ(signedVolume(door), 4.0);
  EXPECT_EQ(door.colors.size(), door.positions.size());
  EXPECT_FALSE(isBlocked(door, {2, 1, 1}, {2, 1, -1}));
  EXPECT_TRUE(isBlocked(door, {2, 2.5f, 1}, {2, 2.5f, -1}));
}

TEST(TownPlan, KeepsHousesApartAndOffTheStreets) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const TownPlan plan = planTown(seed);
    EXPECT_EQ(plan.blocks.size(), 12u);
    EXPECT_GE(plan.houses.size(), 44u);
    for (size_t i = 0; i < plan.houses.size(); ++i) {
      const House& a = plan.houses[i];
      EXPECT_GE(a.width, 6.0f);
      EXPECT_LE(a.width, 11.0f);
      const bool isOnBlock = std::any_of(plan.blocks.begin(), plan.blocks.end(), [&](const TownBlock& block) {
        return !block.isSquare && a.position.x - a.width / 2 > block.lower.x &&
               a.position.x + a.width / 2 < block.upper.x && a.position.z - a.depth / 2 > block.lower.y &&
               a.position.z + a.depth / 2 < block.upper.y;
      });
      EXPECT_TRUE(isOnBlock) << seed << " " << i;
      for (size_t j = 0; j < i; ++j) {
        const House& b = plan.houses[j];
        const bool meet = std::abs(a.position.x - b.position.x) < (a.width + b.width) / 2 &&
                          std::abs(a.position.z - b.position.z) < (a.depth + b.depth) / 2;
        EXPECT_FALSE(meet) << seed << ": " << i << " and " << j;
      }
    }
  }
}

TEST(TownHouse, IsMadeOfClosedSolids) {
  House house;
  for (const RoofKind roof : {RoofKind::kFlat, RoofKind::kFrontGable, RoofKind::kSideGable}) {
    for (const int storeys : {1, 3}) {
      for (const size_t detail : {1u, 2u}) {
        house.roof = roof;
        house.storeys = storeys;
        EXPECT_TRUE(isBalanced(makeHouse(house, detail)));
      }
    }
  }
  for (const Mesh& mesh : {makeRoundTree(glm::vec3(1)), makePointedTree(glm::vec3(1)), makeCar(glm::vec3(1)),
                           makeLamp(), makeClockTower()}) {
    EXPECT_TRUE(isBalanced(mesh));
    EXPECT_GT(signedVolume(mesh), 0.0);
    EXPECT_NEAR(boundsOf(mesh).lower.y, 0.0f, 1e-5f);
  }
}

TEST(TownPortals, AreOpenAndLookOntoTheStreet) {
  const TownPlan plan = planTown(1);
  const std::vector<Portal> portals = townPortals(plan);
  size_t next = 0;
  for (const House& house : plan.houses) {
    Mesh mesh = makeHouse(house, 1);
    const glm::mat4 worldFromHouse = house.worldFromHouse();
    for (glm::vec3& position : mesh.positions) {
      position = glm::vec3(worldFromHouse * glm::vec4(position, 1));
    }
    for (int bay = 0; bay < bayCount(house.width); ++bay) {
      const Portal& portal = portals.at(next++);
      EXPECT_NEAR(glm::length(portal.normal), 1.0f, 1e-6f);
      const glm::vec3 frame = glm::normalize(glm::cross(portal.halfRight, portal.halfUp));
      EXPECT_LT(glm::distance(frame, portal.normal), 1e-6f);
      EXPECT_GT(glm::dot(portal.normal, portal.center - house.position), 0.0f) << "it looks out";
      for (const float x : {-0.9f, 0.0f, 0.9f}) {
        for (const float y : {-0.9f, 0.0f, 0.9f}) {
          const glm::vec3 point = portal.center + x * portal.halfRight + y * portal.halfUp;
          EXPECT_FALSE(isBlocked(mesh, point + 0.25f * portal.normal, point - 0.2f * portal.normal))
              << next << " " << x;
        }
      }
      for (const float x : {-1.15f, 1.15f}) {
        const glm::vec3 point = portal.center + x * portal.halfRight;
        EXPECT_TRUE(isBlocked(mesh, point + 0.25f * portal.normal, point - 0.2f * portal.normal)) << next << " " << x;
      }
    }
  }
  EXPECT_EQ(next, portals.size());
  EXPECT_GE(portals.size(), 120u);
}

TEST(BuiltinTown, HasTrianglesObjectsAndGuides) {
  const GuidedScene town = loadGuidedScene("builtin:town", {.fit = false, .shading = Shading::kNone});
  EXPECT_GE(town.mesh.triangles.size(), 100'000u);
  ASSERT_EQ(town.objectOfTriangle.size(), town.mesh.triangles.size());
  const std::set<uint32_t> objects(town.objectOfTriangle.begin(), town.objectOfTriangle.end());
  const TownPlan plan = planTown(1);
  EXPECT_EQ(objects.size(), 1 + plan.houses.size() + 1 + plan.things.size());
  EXPECT_EQ(*objects.rbegin(), objects.size() - 1) << "identities count from 0 without gaps";
  EXPECT_EQ(town.guides.portals.size(), townPortals().size());
  ASSERT_TRUE(town.guides.target);
  Box tower;
  for (size_t i = 0; i < town.mesh.triangles.size(); ++i) {
    if (town.objectOfTriangle[i] == town.guides.target->object) {
      for (glm::length_t corner = 0; corner < 3; ++corner) {
        tower.add(town.mesh.positions[town.mesh.triangles[i][corner]]);
      }
    }
  }
  // Coordinates of up to 50 m as floats.
  EXPECT_LT(glm::distance(tower.lower, town.guides.target->box.lower), 1e-5f);
  EXPECT_LT(glm::distance(tower.upper, town.guides.target->box.upper), 1e-5f);

  const GuidedScene fitted = loadGuidedScene("builtin:town");
  const Portal expected = moved(town.guides.portals[5], fitted.worldFromScene);
  EXPECT_EQ(fitted.guides.portals[5].corners(), expected.corners());
  EXPECT_LT(glm::length(expected.corners()[0]), 1.0f);
}

TEST(BuiltinTown, FollowsTheSeed) {
  const Mesh one = flatten(makeBuiltinScene("builtin:town,seed=5"));
  const Mesh again = flatten(makeBuiltinScene("builtin:town,seed=5"));
  EXPECT_EQ(one.positions, again.positions);
  EXPECT_EQ(one.colors, again.colors);
  EXPECT_NE(one.positions, flatten(makeBuiltinScene("builtin:town,seed=6")).positions);
}

}  // namespace
}  // namespace ocelli
