// Projects the vertices of a block many at a time, in the widest vectors that the CPU has. All steps are those of
// SegmentRasterizer and BendProjection::project(), in the same order and without fused operations: so results are the
// same, bit by bit, on every CPU.
#pragma once

#include "oc_core/render/block_vertices.h"
#include "oc_core/render/half_spaces.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

/// What a straight segment projects by.
struct SegmentSetup {
  glm::dvec4 uRow{0};  ///< u times its weight
  glm::dvec4 vRow{0};
  glm::dvec4 weightRow{0};
  // Vertices outside of these are those of triangles that may have to be clipped.
  glm::dvec3 beginNormal{0};  ///< of the first plane
  double beginDistance = 0;
  double leastHeight = 0;  ///< over the first plane
  float lower = 0;         ///< u and v, pixels
  float upperU = 0;
  float upperV = 0;
};

/// Images of vertices, in the order of the block.
struct SegmentImages {
  alignas(64) std::array<float, BlockVertices::kMaxCount> u;
  alignas(64) std::array<float, BlockVertices::kMaxCount> v;
  alignas(64) std::array<float, BlockVertices::kMaxCount> inverseZ;
  /// unknown() for vertices that may have to be clipped.
  std::array<CentreCell, BlockVertices::kMaxCount> cells;
};

void projectBlock(const SegmentSetup& setup, const BlockVertices& points, SegmentImages& images);

/// What the conics of a bend project by; places are taken from C0 (ray_transition.h).
struct BendSetup {
  glm::dvec3 origin{0};  ///< C0
  glm::dvec3 beyond{0};  ///< C1
  glm::dvec3 axis{0};
  glm::dvec3 linePoint{0};
  glm::dvec3 lineDirection{0};
  glm::dvec3 border{0};
  HalfSpace from{0};
  HalfSpace to{0};
  // In the world.
  HalfSpace first{0};  ///< behind the first plane of the bend
  HalfSpace last{0};   ///< before the last one
  glm::dmat4 before{1};
  glm::dmat4 after{1};
  double maxPixels = 0;
  double minWeight = 0;
};

/// BendImage of vertices, in the order of the block.
struct BendImages {
  using Numbers = std::array<double, BlockVertices::kMaxCount>;
  alignas(64) Numbers u;
  alignas(64) Numbers v;
  alignas(64) Numbers weight;
  alignas(64) Numbers behindFirst;
  alignas(64) Numbers beforeLast;
  alignas(64) Numbers share;
  alignas(64) std::array<uint64_t, BlockVertices::kMaxCount> imaged;   ///< 0 or not
  alignas(64) std::array<uint64_t, BlockVertices::kMaxCount> outside;  ///< kBeforeFirst and kBeyondLast, or 0
  std::array<CentreCell, BlockVertices::kMaxCount> cells;              ///< unknown() without an image

  static constexpr uint64_t kBeforeFirst = 1;  ///< before the first plane of the bend
  static constexpr uint64_t kBeyondLast = 2;

  /// Finds the cells of so many.
  void findCells(size_t count) {
    for (size_t i = 0; i < count; ++i) {
      cells[i] =
          imaged[i] != 0 ? CentreCell::at(static_cast<float>(u[i]), static_cast<float>(v[i])) : CentreCell::unknown();
    }
  }
};

void projectBlock(const BendSetup& setup, const BlockVertices& points, BendImages& images);

}  // namespace ocelli
