// Walks that cover a floor: lanes back and forth, one beside the other, as a cart with a camera is driven.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/scene/scene_guides.h"

namespace ocelli {

/// A rectangle of free floor (x, z) that lanes cover from one of its corners on.
struct LaneArea {
  glm::vec2 start{0};     ///< where the first lane begins
  glm::vec2 opposite{1};  ///< the other corner across
  bool isAlongX = true;   ///< of the lanes
};

/// The walk of `sea.count` positions, each `sea.spacing` after the one before, through the areas in their order; lanes
/// are as far apart. Its points are where it turns; from one area to the next it goes straight. The areas must hold
/// that many positions.
std::vector<glm::vec3> laneWalk(const std::vector<LaneArea>& areas, const SeaWalk& sea, float eyeHeight);

}  // namespace ocelli
