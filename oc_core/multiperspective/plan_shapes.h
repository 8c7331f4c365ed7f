// What plans draw of rays: their pieces within the scene, and outlines around points.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/multiperspective/ray_pieces.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// The piece within the box, which it enters at most once; without points where it misses the box.
RayPiece clipped(const RayPiece& piece, const Box& box);

/// Of two different points or more, in order around it; fewer than 3 where all are on one line.
std::vector<glm::vec2> convexHull(std::vector<glm::vec2> points);

}  // namespace ocelli
