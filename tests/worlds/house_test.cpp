#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/house_furnishing.h"
#include "oc_core/worlds/house_furniture.h"
#include "oc_core/worlds/house_mesh.h"
#include "oc_core/worlds/house_plan.h"
#include "tests/scene/mesh_checks.h"
#include "tests/worlds/plan_checks.h"

namespace ocelli {
namespace {

constexpr uint64_t kHouses = 60;

TEST(HousePlan, RoomsStandApartWithinTheWalls) {
  std::set<int> storeys;
  for (uint64_t seed = 0; seed < kHouses; ++seed) {
    const HousePlan plan = planHouse({seed});
    storeys.insert(plan.storeys);
    EXPECT_GE(plan.rooms.size(), 7u * static_cast<size_t>(plan.storeys));
    for (size_t i = 0; i < plan.rooms.size(); ++i) {
      const HouseRoom& a = plan.rooms[i];
      EXPECT_GE(a.area.lower.x, plan.inside.lower.x);
      EXPECT_LE(a.area.upper.x, plan.inside.upper.x);
      // Sums of floats of up to 10 m.
      EXPECT_GE(a.area.lower.y, plan.inside.lower.y - 1e-5f);
      EXPECT_LE(a.area.upper.y, plan.inside.upper.y + 1e-5f);
      EXPECT_GE(std::min(a.area.size().x, a.area.size().y), 1.5f);
      for (size_t j = 0; j < i; ++j) {
        const HouseRectangle grown{plan.rooms[j].area.lower - 0.9f * kInnerWall,
                                   plan.rooms[j].area.upper + 0.9f * kInnerWall};
        EXPECT_FALSE(a.storey == plan.rooms[j].storey && a.area.meets(grown))
            << seed << ": a wall parts " << i << " and " << j;
      }
    }
  }
  EXPECT_EQ(storeys, (std::set<int>{1, 2}));
  EXPECT_EQ(planHouse({1, 1}).storeys, 1);
  EXPECT_EQ(planHouse({1, 2}).storeys, 2);
}

TEST(HousePlan, DoorsAreWideEnoughAndLeadSomewhere) {
  for (uint64_t seed = 0; seed < kHouses; ++seed) {
    const HousePlan plan = planHouse({seed});
    EXPECT_EQ(plan.doors.front().to, kOutdoors);
    for (const HouseDoor& door : plan.doors) {
      EXPECT_GE(2 * door.halfWidth, kMinDoorWidth - 1e-6f);
      // The doorway lies within both rooms' walls.
      const bool alongX = door.normal.z != 0;
      const float along = alongX ? door.place.x : door.place.z;
      for (const size_t room : {door.from, door.to}) {
        if (room != kOutdoors) {
          const HouseRectangle& area = plan.rooms[room].area;
          EXPECT_GE(along - door.halfWidth, alongX ? area.lower.x : area.lower.y) << seed;
          EXPECT_LE(along + door.halfWidth, alongX ? area.upper.x : area.upper.y) << seed;
        }
      }
    }
  }
}

TEST(HousePlan, FurnitureLeavesWaysToAllOfARoom) {
  size_t pieces = 0;
  for (uint64_t seed = 0; seed < kHouses; ++seed) {
    const HousePlan plan = planHouse({seed});
    pieces += plan.furniture.size();
    for (size_t room = 0; room < plan.rooms.size(); ++room) {
      EXPECT_TRUE(isRoomWalkable(plan, room)) << seed << ": " << room;
    }
    for (size_t i = 0; i < plan.furniture.size(); ++i) {
      const HouseFurniture& a = plan.furniture[i];
      EXPECT_TRUE(a.area.meets(plan.rooms[a.room].area));
      for (size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(a.room == plan.furniture[j].room && a.area.meets(plan.furniture[j].area)) << seed;
      }
    }
  }
  EXPECT_GE(pieces, 20 * kHouses);
}

TEST(HousePlan, WalkableRoomsAreToldFromBlockedOnes) {
  HousePlan plan = planHouse({1});
  const size_t room = plan.doors.front().from;
  ASSERT_TRUE(isRoomWalkable(plan, room));
  // A wall of furniture across the hall, from side to side.
  HouseFurniture barrier;
  barrier.room = room;
  const HouseRectangle& area = plan.rooms[room].area;
  barrier.area = {{area.lower.x, area.center().y - 0.1f}, {area.upper.x, area.center().y + 0.1f}};
  plan.furniture.push_back(barrier);
  EXPECT_FALSE(isRoomWalkable(plan, room));
}

TEST(HouseWalkMap, ConnectsAllRoomsWithTheTerrace) {
  for (uint64_t seed = 0; seed < kHouses; ++seed) {
    const HousePlan plan = planHouse({seed});
    const WalkMap map = houseWalkMap(plan);
    // Openings lie in the middle of walls; those of outer walls are the thickest.
    expectSoundWalkMap(map, kOuterWall / 2);
    const size_t stairs = plan.storeys > 1 ? 1 + 2 * 2 : 0;  // the flight, and two landings more in each stairwell
    EXPECT_EQ(map.cells.size(), 1 + plan.rooms.size() + stairs);
    EXPECT_GE(map.portals.size(), plan.doors.size());
    EXPECT_GE(housePath(plan).size(), 5u);
  }
}

TEST(HouseWalkMap, StairsRiseByAStorey) {
  const HousePlan plan = planHouse({1, 2});
  const WalkMap map = houseWalkMap(plan);
  const WalkCell& flight = map.cells.back();
  ASSERT_EQ(flight.floorRise, kFloorToFloor);
  // Each end meets an opening of its level.
  for (const float end : {-1.0f, 1.0f}) {
    const glm::vec3 place =
        flight.center + flight.axis * (end * flight.halfLength) + glm::vec3(0, end * flight.floorRise / 2, 0);
    EXPECT_TRUE(std::any_of(map.portals.begin(), map.portals.end(), [&](const WalkPortal& portal) {
      return glm::distance(portal.opening.center - portal.opening.halfUp, place) < 1e-4f;
    }));
  }
}

TEST(HouseMesh, IsMadeOfClosedSolids) {
  for (const uint64_t seed : {1u, 2u, 3u}) {
    EXPECT_TRUE(isBalanced(makeHouseShell(planHouse({seed}), 1.0f)));
  }
}

TEST(HouseFurniture, StandsInItsPlaceAndIsClosed) {
  for (const FurnitureKind kind :
       {FurnitureKind::kBed, FurnitureKind::kWardrobe, FurnitureKind::kDesk, FurnitureKind::kChair,
        FurnitureKind::kSofa, FurnitureKind::kShelf, FurnitureKind::kCounter, FurnitureKind::kTable,
        FurnitureKind::kBathtub, FurnitureKind::kToilet, FurnitureKind::kPlant}) {
    const Mesh mesh = makeFurniture(kind, glm::vec3(0.5f));
    EXPECT_TRUE(isBalanced(mesh)) << static_cast<int>(kind);
    const Box box = boundsOf(mesh);
    const glm::vec2 half = furnitureSize(kind) * 0.5f;
    // Sums of floats of about 1 m.
    EXPECT_GE(box.lower.x, -half.x - 1e-5f) << static_cast<int>(kind);
    EXPECT_LE(box.upper.x, half.x + 1e-5f) << static_cast<int>(kind);
    EXPECT_GE(box.lower.z, -half.y - 1e-5f) << static_cast<int>(kind);
    EXPECT_LE(box.upper.z, half.y + 1e-5f) << static_cast<int>(kind);
    EXPECT_NEAR(box.lower.y, 0, 1e-6f) << static_cast<int>(kind);
    EXPECT_GT(signedVolume(mesh), 0.0);
  }
}

TEST(BuiltinHouse, HasTrianglesObjectsAndGuides) {
  const Scene scene = makeBuiltinScene("builtin:house,triangles=958000");
  // The last mesh may end one split of an edge beyond its share.
  EXPECT_NEAR(static_cast<double>(triangleCount(scene)), 958'000, 2);
  const HousePlan plan = planHouse({});
  const auto leaves =
      std::count_if(plan.doors.begin(), plan.doors.end(), [](const HouseDoor& door) { return door.hasLeaf; });
  EXPECT_EQ(scene.instances.back().object, plan.furniture.size() + static_cast<size_t>(leaves));
  EXPECT_EQ(scene.guides.portals.size(), 2 * plan.doors.size());
  ASSERT_TRUE(scene.guides.target);
  EXPECT_FALSE(scene.guides.walk) << "where one can walk is found from the geometry";
  EXPECT_FALSE(scene.guides.path.empty());
  EXPECT_GE(triangleCount(makeBuiltinScene("builtin:house")), 50'000u);
}

TEST(BuiltinHouse, FollowsTheSeed) {
  const Mesh one = flatten(makeBuiltinScene("builtin:house,seed=5"));
  const Mesh again = flatten(makeBuiltinScene("builtin:house,seed=5"));
  EXPECT_EQ(one.positions, again.positions);
  EXPECT_EQ(one.colors, again.colors);
  EXPECT_NE(one.positions, flatten(makeBuiltinScene("builtin:house,seed=6")).positions);
}

}  // namespace
}  // namespace ocelli
