// What closed outlines wind around, as triangles.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace ocelli {

struct FilledOutline {
  std::vector<glm::dvec2> corners;
  std::vector<glm::uvec3> triangles;  ///< counter-clockwise
};

/// The places around which the outlines wind (nonzero rule), cut into trapezoids between the heights of their corners,
/// one trapezoid as long as the same two edges bound it. Where edges cross between two heights, the place of the
/// crossing is moved to one of these. Takes the number of corners squared.
FilledOutline fillOutlines(const std::vector<std::vector<glm::dvec2>>& outlines);

}  // namespace ocelli
