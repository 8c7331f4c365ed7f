// Which parts of a mesh are the surfaces of solids. Such a surface is only seen from its outside; an open one, a wall
// or a leaf, is seen from both sides.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

enum class Closure : uint8_t {
  kOpen,
  kFacesOut,  ///< closed, its triangles counter-clockwise seen from outside
  kFacesIn,   ///< closed, but turned inside out
};

/// One entry a triangle. A part is what hangs together through vertices, those of equal position at its borders taken
/// as one. Borders are made of the edges that no triangle of the opposite direction shares, so a part whose triangles
/// disagree about outside is open. A part is closed where the holes within its borders are less than `largestHole` of
/// its area, a border of length L taken as a circle (L^2 / 4 pi): scans have small holes where nothing was seen, and
/// still are solids. Every index must be in range.
std::vector<Closure> closureOfTriangles(const Mesh& mesh, double largestHole = 0.1);

}  // namespace ocelli
