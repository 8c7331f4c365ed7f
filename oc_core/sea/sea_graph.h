// Which positions of a sea are next to each other: the Delaunay triangulation of the centres of projection (section
// 3.5.4.2.1), by Boost.Polygon.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ocelli {

/// The two coordinates of positions that spread widest: the text's lie in a plane at the height of eyes. At least one
/// position.
std::vector<glm::dvec2> planePositions(std::span<const glm::dvec3> positions);

/// The edges of the triangulation, each once, the lower number first, in order. Positions that stand at the same place
/// of the plane hang on each other in a row. All positions are connected.
std::vector<std::array<uint32_t, 2>> delaunayEdges(std::span<const glm::dvec2> positions);

}  // namespace ocelli
