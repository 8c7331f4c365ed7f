// A canyon: terrain from a seeded height field that a winding river has cut into (the kind of scene of dissertation
// section 4.3.1.5, where a camera looks along the river).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

struct CanyonOptions {
  uint64_t seed = 1;
  size_t cells = 256;  ///< of the height field, along each side; 8 or more
};

inline constexpr float kCanyonHalfSize = 500;  ///< metres, along x and z
inline constexpr float kRiverHalfWidth = 11;   ///< metres

/// The triangles of a canyon, and the cells whose canyon comes nearest to so many.
size_t canyonTriangles(size_t cells);
size_t canyonCells(size_t triangles);

/// The middle of the river on its surface, upstream: from the south edge (+z) to the north edge, with x a function of
/// z. In metres.
std::vector<glm::vec3> canyonPath(uint64_t seed);

/// A closed solid: the terrain, its sides, and the bottom. `path` is canyonPath() of the same seed.
Mesh makeCanyon(const CanyonOptions& options, const std::vector<glm::vec3>& path);

}  // namespace ocelli
