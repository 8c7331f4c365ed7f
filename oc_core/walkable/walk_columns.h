// The triangles of a scene as columns of solid spans: the height field that floors are found in. Recast makes it; this
// header and walk_columns_missing.cpp are all that a program without Recast has of it.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Something solid in a column, from `lower` to `upper`, in units of the scene.
struct SolidSpan {
  float lower = 0;
  float upper = 0;
  bool isFloor = false;  ///< whether one can stand on it, where there is room over it
};

/// Columns on a grid over x and z; column (x, z) has the spans from first[z * width + x] to before the next one's, from
/// the lowest to the highest.
struct WalkColumns {
  int width = 0;  ///< along x
  int depth = 0;  ///< along z
  float cellSize = 1;
  glm::vec2 origin{0};  ///< x and z of the corner of column (0, 0)
  std::vector<uint32_t> first;
  std::vector<SolidSpan> spans;
};

struct WalkRaster {
  float cellSize = 0.1f;
  float slopeDegrees = 40;
  float stepHeight = 0.35f;
  float agentHeight = 1.8f;
  bool bothSides = false;  ///< floors may be seen from below, too: their triangles may face downwards
};

/// More columns than these are never made.
inline constexpr double kMaxWalkColumns = 6e6;

/// A span covers each column that its triangle touches. The grid must have kMaxWalkColumns at most, and a height of
/// 8,000 half cells. Throws InputError where the program was built without Recast, WorkError where memory is missing.
WalkColumns rasterizedColumns(const Mesh& mesh, const WalkRaster& raster, const Progress& progress);

}  // namespace ocelli
