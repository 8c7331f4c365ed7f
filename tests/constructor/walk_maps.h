// Maps to walk in for tests, made by hand, and scenes with their walls.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/scene/walk_map.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::test {

/// A room or a tunnel: its box in the plan, x to the east and z to the south.
struct PlanCell {
  glm::vec2 westNorth{0};
  glm::vec2 eastSouth{1};
  bool tunnel = false;
  float height = 2.4f;
  float floor = 0;      ///< at its centre
  float floorRise = 0;  ///< towards the east or the south, whichever it is longer
};

/// An opening from one to the next, in the middle between their sides.
struct PlanDoor {
  uint32_t from = 0;
  uint32_t to = 0;
  float along = 0;  ///< of its middle: x of one that leads north or south, z of one that leads east or west
  float width = 1;
  float height = 2;
  float floor = 0;
};

/// A map and its scene with floors, ceilings and walls. All of it can be turned about the vertical through the origin.
struct PlannedHouse {
  std::vector<PlanCell> cells;
  std::vector<PlanDoor> doors;

  WalkMap map(float degrees = 0) const;
  GuidedScene scene(float degrees = 0, bool ceilings = true) const;
};

/// A hall of 8 by 6 metres with doors off the middle on three sides, a corridor with rooms on both sides, two rooms
/// that are joined by two doors in one wall, stairs up, and a room at their top. Every cell can be reached.
PlannedHouse smallHouse();

}  // namespace ocelli::test
