#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/city_house.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/scene/mesh_checks.h"
#include "tests/worlds/plan_checks.h"

namespace ocelli {
namespace {

constexpr uint64_t kCities = 30;

bool coversLine(std::vector<std::array<float, 2>> spans, float from, float to) {
  std::sort(spans.begin(), spans.end());
  for (const auto& [low, high] : spans) {
    if (low > from + 1e-4f) {
      return false;
    }
    from = std::max(from, high);
  }
  return from >= to - 1e-4f;
}

TEST(CityPlan, StreetsBlocksAndHousesStandApart) {
  for (uint64_t seed = 0; seed < kCities; ++seed) {
    const CityPlan plan = planCity({seed, 100 + 10.0f * static_cast<float>(seed % 10)});
    std::vector<CityRectangle> ground;
    for (const CityStreet& street : plan.streets) {
      ground.push_back(street.area);
      EXPECT_GE(street.width(), 3.0f);
    }
    for (const CityBlock& block : plan.blocks) {
      ground.push_back(block.area);
    }
    double area = 0;
    for (size_t i = 0; i < ground.size(); ++i) {
      area += ground[i].size().x * ground[i].size().y;
      for (size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(ground[i].meets(ground[j])) << seed << ": " << i << " and " << j;
      }
    }
    const double whole = plan.inside.size().x * plan.inside.size().y;
    EXPECT_NEAR(area, whole, 1e-5 * whole) << "floats: streets and blocks fill the city";
    for (size_t i = 0; i < plan.houses.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(plan.houses[i].area.meets(plan.houses[j].area)) << seed << ": " << i << " and " << j;
      }
      for (const CityStreet& street : plan.streets) {
        EXPECT_FALSE(plan.houses[i].area.meets(street.area)) << seed << ": " << i;
      }
    }
    EXPECT_GE(std::count_if(plan.blocks.begin(), plan.blocks.end(), [](const auto& b) { return b.isSquare; }), 1);
  }
}

TEST(CityPlan, HousesCloseEveryStreetSide) {
  for (uint64_t seed = 0; seed < kCities; ++seed) {
    const CityPlan plan = planCity({seed, 150});
    for (const CityBlock& block : plan.blocks) {
      for (const CitySide side : kCitySides) {
        if (block.isSquare || block.streetWidth[static_cast<size_t>(side)] == 0) {
          continue;
        }
        const bool alongX = side == CitySide::kNorth || side == CitySide::kSouth;
        const glm::length_t along = alongX ? 0 : 1;
        const glm::length_t across = 1 - along;
        const bool isUpper = side == CitySide::kEast || side == CitySide::kSouth;
        std::vector<std::array<float, 2>> spans;
        for (const CityHouse& house : plan.houses) {
          const float back = isUpper ? block.area.upper[across] - house.area.upper[across]
                                     : house.area.lower[across] - block.area.lower[across];
          // A facade stands back by 1.6 m at most.
          if (house.area.meets(block.area) && back < 1.7f) {
            spans.push_back({house.area.lower[along], house.area.upper[along]});
          }
        }
        // At the corners of a block facades stand back from the other street, too.
        EXPECT_TRUE(coversLine(spans, block.area.lower[along] + 1.7f, block.area.upper[along] - 1.7f)) << seed;
      }
    }
  }
}

TEST(CityPlan, StreetsAreOfManyWidthsWithOffsetsAndDeadEnds) {
  size_t alleys = 0;
  size_t offsets = 0;
  for (uint64_t seed = 0; seed < kCities; ++seed) {
    const CityPlan plan = planCity({seed, 150});
    std::set<int> widths;
    for (const CityStreet& street : plan.streets) {
      widths.insert(static_cast<int>(10 * street.width()));
      alleys += street.isAlley ? 1 : 0;
      for (const CityStreet& other : plan.streets) {
        // Two that end at the two sides of a third, not in one line.
        const bool share = !street.isAlley && !other.isAlley && street.isAlongX == other.isAlongX;
        const glm::length_t along = street.isAlongX ? 0 : 1;
        const glm::length_t across = 1 - along;
        const float gap = other.area.lower[along] - street.area.upper[along];
        const float offset = std::abs(other.area.center()[across] - street.area.center()[across]);
        offsets += share && gap > 0 && gap < 15 && offset > 0.5f && offset < 20 ? 1 : 0;
      }
    }
    EXPECT_GE(widths.size(), 5u) << seed;
  }
  EXPECT_GE(alleys, kCities);
  EXPECT_GE(offsets, kCities);
}

TEST(CityWalkMap, ConnectsAllStreetsWithTheGate) {
  for (uint64_t seed = 0; seed < kCities; ++seed) {
    for (const float size : {60.0f, 150.0f}) {
      const CityPlan plan = planCity({seed, size});
      const WalkMap map = cityWalkMap(plan);
      expectSoundWalkMap(map, 0);
      double area = 0;
      for (const WalkCell& cell : map.cells) {
        area += 4.0 * cell.halfLength * cell.halfWidth;
      }
      double expected = 2 * kCityGateHalfWidth * (kCityWallThickness + kCityForecourt);
      for (const CityStreet& street : plan.streets) {
        expected += street.area.size().x * street.area.size().y;
      }
      for (const CityBlock& block : plan.blocks) {
        expected += block.isSquare ? block.area.size().x * block.area.size().y : 0;
      }
      EXPECT_NEAR(area, expected, 1e-5 * expected) << "cells are all streets, squares and the road before the gate";
      const std::vector<glm::vec3> path = cityPath(plan);
      EXPECT_GE(path.size(), 3u) << "from before the gate through it";
      EXPECT_GT(path.front().z, plan.gate.z) << "it begins outside";
    }
  }
}

TEST(CityWalkMap, HasRingsWhereFacadesChange) {
  const WalkMap map = cityWalkMap(planCity({1, 150}));
  size_t modulated = 0;
  for (const WalkCell& cell : map.cells) {
    modulated += std::any_of(cell.rings.begin(), cell.rings.end(),
                             [&](const WalkRing& ring) { return std::abs(ring.left - cell.rings[0].left) > 0.1f; });
  }
  EXPECT_GE(modulated, 10u);
}

TEST(CityHouse, IsMadeOfClosedSolids) {
  CityHouse house;
  house.area = {{2, 3}, {11, 14}};
  house.hasFacade = {true, false, false, true};
  for (const CityRoof roof : {CityRoof::kFlat, CityRoof::kAlongX, CityRoof::kAlongZ}) {
    house.roof = roof;
    const Mesh mesh = makeCityHouse(house, 1);
    EXPECT_TRUE(isBalanced(mesh));
    // Nothing but eaves and awnings, which are higher than who walks by, and window sills stand out.
    for (const glm::vec3& p : mesh.positions) {
      const bool isBeside = p.x < 1.8f || p.x > 11.2f || p.z < 2.8f || p.z > 14.2f;
      EXPECT_TRUE(!isBeside || p.y > 2.2f) << p.x << " " << p.y << " " << p.z;
    }
  }
  for (const Mesh& mesh : {makeFountain(), makeBench(), makeBin(glm::vec3(1))}) {
    EXPECT_TRUE(isBalanced(mesh));
    EXPECT_GT(signedVolume(mesh), 0.0);
    EXPECT_NEAR(boundsOf(mesh).lower.y, 0.0f, 1e-5f);
  }
}

TEST(BuiltinCity, HasAMillionTrianglesObjectsAndGuides) {
  const Scene scene = makeBuiltinScene("builtin:city");
  EXPECT_NEAR(static_cast<double>(triangleCount(scene)), 1e6, 1e5);
  const CityPlan plan = planCity({});
  EXPECT_EQ(scene.instances.back().object, plan.houses.size() + plan.things.size());
  EXPECT_EQ(scene.guides.portals.size(), 2 * cityWalkMap(plan).portals.size());
  ASSERT_TRUE(scene.guides.target);
  EXPECT_FALSE(scene.guides.walk) << "where one can walk is found from the geometry";
  EXPECT_FALSE(scene.guides.path.empty());
}

TEST(BuiltinCity, HasAsManyTrianglesAsAsked) {
  const Scene scene = makeBuiltinScene("builtin:city,size=60,triangles=400000");
  // The last mesh may end one split of an edge beyond its share.
  EXPECT_NEAR(static_cast<double>(triangleCount(scene)), 4e5, 2);
}

TEST(BuiltinCity, FollowsTheSeed) {
  const Mesh one = flatten(makeBuiltinScene("builtin:city,size=60,seed=5"));
  const Mesh again = flatten(makeBuiltinScene("builtin:city,size=60,seed=5"));
  EXPECT_EQ(one.positions, again.positions);
  EXPECT_EQ(one.colors, again.colors);
  EXPECT_NE(one.positions, flatten(makeBuiltinScene("builtin:city,size=60,seed=6")).positions);
}

}  // namespace
}  // namespace ocelli
