// What is found in worlds that are made, against what their plans say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/walkable/walkable.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/house_plan.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/town_plan.h"

namespace ocelli {
namespace {

WalkMap foundIn(const std::string& source) {
  return findWalkMap(loadScene(source, {.fit = false, .shading = Shading::kNone}), {});
}

bool isWithin(const WalkCell& cell, const glm::vec3& point, float slack) {
  const glm::vec3 off = point - cell.center;
  const float along = glm::dot(off, cell.axis);
  const float floor = cell.floorRise * along / (2 * cell.halfLength);
  return std::abs(along) <= cell.halfLength + slack &&
         std::abs(glm::dot(off, cell.right())) <= cell.halfWidth + slack && std::abs(off.y - floor) < 0.6f;
}

/// Whether a portal of the map stands there, within that distance, and looks along or against `normal`.
bool hasPortalAt(const WalkMap& map, const glm::vec3& place, const glm::vec3& normal, float within) {
  return std::any_of(map.portals.begin(), map.portals.end(), [&](const WalkPortal& portal) {
    const glm::vec3 floor = portal.opening.center - portal.opening.halfUp;
    return glm::distance(floor, place) < within && std::abs(glm::dot(portal.opening.normal, normal)) > 0.9f;
  });
}

/// The share of the floor of the truth, in points of a quarter metre, that lies in boxes of the same part of the map.
double coveredShare(const WalkMap& map, const WalkMap& truth) {
  size_t inside = 0;
  size_t all = 0;
  for (const WalkCell& cell : truth.cells) {
    for (float u = -cell.halfLength + 0.125f; u < cell.halfLength; u += 0.25f) {
      for (float v = -cell.halfWidth + 0.125f; v < cell.halfWidth; v += 0.25f) {
        const glm::vec3 point = cell.center + u * cell.axis + v * cell.right() +
                                glm::vec3(0, cell.floorRise * u / (2 * cell.halfLength), 0);
        ++all;
        inside += std::any_of(map.cells.begin(), map.cells.end(),
                              [&](const WalkCell& found) { return isWithin(found, point, 0.1f); })
                      ? 1
                      : 0;
      }
    }
  }
  return static_cast<double>(inside) / static_cast<double>(all);
}

TEST(WalkableWorlds, HousesHaveTheirRoomsAndDoors) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const std::string source = "builtin:house,seed=" + std::to_string(seed);
    const HousePlan plan = planHouse({.seed = seed});
    const WalkMap map = foundIn(source);
    EXPECT_EQ(std::count_if(map.partOfCell.begin(), map.partOfCell.end(), [](uint32_t part) { return part != 0; }), 0)
        << source << ": one gets everywhere";
    size_t doors = 0;
    for (const HouseDoor& door : plan.doors) {
      // A portal stands at one face of its wall or the other.
      const bool isFound = hasPortalAt(map, door.place, door.normal, 0.45f);
      doors += isFound ? 1 : 0;
      EXPECT_TRUE(isFound) << source << ", door at " << door.place.x << ", " << door.place.y << ", " << door.place.z;
    }
    EXPECT_EQ(doors, plan.doors.size()) << source;
    const WalkMap truth = houseWalkMap(plan);
    for (size_t i = 0; i < truth.cells.size(); ++i) {
      WalkMap cell;
      cell.cells = {truth.cells[i]};
      EXPECT_GT(coveredShare(map, cell), 0.5) << source << ", cell " << i;
    }
    // What lies behind open doors and wardrobes, and under the flight, is none of it.
    EXPECT_GT(coveredShare(map, truth), 0.85) << source;
  }
}

TEST(WalkableWorlds, CitiesHaveTheirStreetsAndCrossings) {
  for (uint64_t seed = 1; seed <= 2; ++seed) {
    const CityPlan plan = planCity({.seed = seed});
    const WalkMap truth = cityWalkMap(plan);
    const WalkMap map = foundIn("builtin:city,seed=" + std::to_string(seed));
    EXPECT_EQ(std::count_if(map.partOfCell.begin(), map.partOfCell.end(), [](uint32_t part) { return part != 0; }), 0)
        << seed << ": one gets everywhere";
    for (size_t i = 0; i < truth.cells.size(); ++i) {
      EXPECT_TRUE(std::any_of(map.cells.begin(), map.cells.end(),
                              [&](const WalkCell& found) { return isWithin(found, truth.cells[i].center, 0.1f); }))
          << seed << ", cell " << i;
    }
    EXPECT_GT(coveredShare(map, truth), 0.95) << seed;
    for (const WalkCell& cell : map.cells) {
      EXPECT_TRUE(std::any_of(truth.cells.begin(), truth.cells.end(),
                              [&](const WalkCell& real) {
                                return isWithin(real, cell.center, 1.5f);  // facades stand back by as much
                              }))
          << seed << ", found at " << cell.center.x << ", " << cell.center.z;
    }
  }
}

TEST(WalkableWorlds, TheTownHasItsStreetsAndTheDoorsOfItsHouses) {
  const TownPlan plan = planTown(1);
  const WalkMap map = foundIn("builtin:town");
  for (const float x : plan.streetsNorthSouth) {
    for (const float z : plan.streetsEastWest) {
      EXPECT_TRUE(std::any_of(map.cells.begin(), map.cells.end(),
                              [&](const WalkCell& cell) {
                                return isWithin(cell, {x, 0, z}, 0.1f);
                              }))
          << "crossing at " << x << ", " << z;
    }
  }
  size_t doors = 0;
  size_t found = 0;
  for (const Portal& portal : townPortals(plan)) {
    const glm::vec3 floor = portal.center - portal.halfUp;
    if (floor.y > 0.3f) {  // windows have sills
      continue;
    }
    ++doors;
    const bool isFound = hasPortalAt(map, floor, portal.normal, 0.5f);
    // A tree or a car may stand before a door.
    const bool isBlocked = std::any_of(plan.things.begin(), plan.things.end(), [&](const TownThing& thing) {
      return glm::distance(thing.position, floor) < 2;
    });
    found += isFound ? 1 : 0;
    EXPECT_TRUE(isFound || isBlocked) << "door at " << floor.x << ", " << floor.y << ", " << floor.z;
  }
  EXPECT_GT(found, 0.9 * static_cast<double>(doors));
}

TEST(WalkableWorlds, HugeScenesGetACoarserGridWithANote) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 3000}, {3000, 0, 3000}, {3000, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const WalkSurvey survey = surveyWalkable(mesh, {});
  EXPECT_GT(survey.cellSize, 1.2);
  EXPECT_LE(std::pow(3000 / survey.cellSize, 2), 6e6);
  ASSERT_EQ(survey.notes.size(), 1U);
  EXPECT_NE(survey.notes[0].find("the scene is large"), std::string::npos);
  EXPECT_EQ(survey.map.cells.size(), 1U);
}

}  // namespace
}  // namespace ocelli
