// What tests of scenes with a plan ask of where one can walk in them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/scene/walk_map.h"
#include "oc_core/worlds/plan_walk.h"

namespace ocelli {

/// All of one part, no two cells of one level on one another, openings between cells that they touch or nearly touch
/// (walls are up to `wall` metres thick), normals into the cells that they are seen from, rings in order.
inline void expectSoundWalkMap(const WalkMap& map, float wall) {
  ASSERT_EQ(map.partOfCell.size(), map.cells.size());
  EXPECT_EQ(std::set<uint32_t>(map.partOfCell.begin(), map.partOfCell.end()).size(), 1u);
  for (size_t i = 0; i < map.cells.size(); ++i) {
    const WalkCell& cell = map.cells[i];
    const CellFootprint a = footprintOf(cell);
    EXPECT_NEAR(glm::length(cell.axis), 1, 1e-6);
    EXPECT_EQ(cell.kind == WalkCellKind::kTunnel, !cell.rings.empty());
    for (size_t r = 0; r < cell.rings.size(); ++r) {
      const WalkRing& ring = cell.rings[r];
      EXPECT_GE(ring.along, r == 0 ? 0 : cell.rings[r - 1].along);
      // Coordinates of up to 200 m as floats.
      EXPECT_LE(ring.along, 2 * cell.halfLength + 1e-4f);
      EXPECT_GE(ring.left, cell.halfWidth - 1e-4f) << "facades stand at the edge of a street or behind it";
      EXPECT_GE(ring.right, cell.halfWidth - 1e-4f);
    }
    for (size_t j = 0; j < i; ++j) {
      const CellFootprint b = footprintOf(map.cells[j]);
      constexpr float kTouching = 1e-3f;
      const bool meet = a.lower.x < b.upper.x - kTouching && b.lower.x < a.upper.x - kTouching &&
                        a.lower.y < b.upper.y - kTouching && b.lower.y < a.upper.y - kTouching;
      const bool isOneLevel = std::abs(cell.center.y - map.cells[j].center.y) < 1;
      EXPECT_FALSE(meet && isOneLevel) << i << " and " << j;
    }
  }
  for (const WalkPortal& portal : map.portals) {
    const Portal& opening = portal.opening;
    EXPECT_LT(glm::distance(glm::normalize(glm::cross(opening.halfRight, opening.halfUp)), opening.normal), 1e-6f);
    const auto holds = [&](uint32_t cell, float side) {
      const CellFootprint area = footprintOf(map.cells[cell]);
      const glm::vec3 place = opening.center + opening.normal * (side * (wall + 0.05f));
      return area.lower.x < place.x && place.x < area.upper.x && area.lower.y < place.z && place.z < area.upper.y;
    };
    EXPECT_TRUE(holds(portal.from, 1)) << "between " << portal.from << " and " << portal.to;
    EXPECT_TRUE(holds(portal.to, -1)) << "between " << portal.from << " and " << portal.to;
  }
}

}  // namespace ocelli
