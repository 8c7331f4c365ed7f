// The surface of a volume as the extractor gives it: quadrilaterals between points in index coordinates
// (volume_grid.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

struct SurfaceQuads {
  std::vector<glm::vec3> points;
  std::vector<std::array<uint32_t, 4>> quads;  ///< counter-clockwise seen from lower values, in index coordinates
  ValueRange range;                            ///< of the voxels
  size_t brokenVoxels = 0;                     ///< that are no numbers; there are no quads then
  size_t crossings = 0;                        ///< edges between voxel centres that the surface crosses: a quad each
};

/// The surface between the voxels above `value` and all others, closed along the faces of the box of the volume. Where
/// it would have more quads than `maxQuads` there are none, and the range and the crossings are those of what was
/// looked at until then.
SurfaceQuads surfaceQuads(const ScalarVolume& volume, double value, size_t maxQuads, const Progress& progress);

}  // namespace ocelli
