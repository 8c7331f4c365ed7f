// A mesh as a pinhole sees it: its vertices projected once, for all that is drawn by cameras with this pinhole.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The image point of a vertex, pixels, and 1/z. 1/z is 0 for one that has no image (PinholeCamera::project).
struct ProjectedVertex {
  float u = 0;
  float v = 0;
  float inverseZ = 0;
};

/// Where image points lie between the centres of pixels, as they are snapped for filling (visibility_buffer.h). A
/// triangle whose corners share a column or a row of cells covers no centre: most triangles of dense scenes do.
class CentreCell {
 public:
  /// Of points farther from the origin than this nothing is known: unknown().
  static constexpr float kMaxPixels = 8192;

  CentreCell() = default;
  CentreCell(float u, float v) : bits_(axis(u) | axis(v) << 16) {}
  /// The same, unknown() where it must be.
  static CentreCell at(float u, float v) {
    return std::max(std::abs(u), std::abs(v)) < kMaxPixels ? CentreCell(u, v) : unknown();
  }
  /// The cell of a point that no triangle is left out for.
  static CentreCell unknown() { return {}; }
  /// False for few of which something is known.
  bool isKnown() const { return bits_ != 0; }

  /// Whether the triangle between three points covers no pixel centre for sure.
  static bool missCentres(CentreCell a, CentreCell b, CentreCell c) {
    const uint32_t different = (a.bits_ ^ b.bits_) | (a.bits_ ^ c.bits_);
    return (((different & 0xffffu) == 0) & ((a.bits_ & 1u) != 0)) |
           (((different >> 16) == 0) & ((a.bits_ & 0x10000u) != 0));
  }

 private:
  /// 2 i + 1 between the centres of pixels i and i + 1, 2 i at the centre of pixel i; 16 bits.
  static uint32_t axis(float pixels) {
    // To the nearest 1/256 pixel, ties to even, as snapToSubPixel(): the last bit of the sum stands for 1.
    constexpr float kIntegerBits = 12582912.0f;  // 1.5 * 2^23
    const uint32_t snapped =
        std::bit_cast<uint32_t>(pixels * 256.0f + kIntegerBits) - std::bit_cast<uint32_t>(kIntegerBits);
    const auto fromCentre = static_cast<int32_t>(snapped - 128);
    return static_cast<uint32_t>(((fromCentre >> 8) << 1) | ((fromCentre & 255) != 0 ? 1 : 0)) & 0xffffu;
  }

  uint32_t bits_ = 0;
};

class ProjectedMesh {
 public:
  /// The mesh must outlive it.
  ProjectedMesh(const PinholeCamera& camera, const Mesh& mesh);

  const PinholeCamera& camera() const { return camera_; }
  const Mesh& mesh() const { return *mesh_; }
  const ProjectedVertex& vertex(uint32_t i) const { return vertices_[i]; }
  std::span<const ProjectedVertex> vertices() const { return vertices_; }
  /// Whether a triangle covers no pixel centre for sure.
  bool missesCentres(const glm::uvec3& triangle) const {
    return CentreCell::missCentres(cells_[triangle.x], cells_[triangle.y], cells_[triangle.z]);
  }

 private:
  PinholeCamera camera_;
  const Mesh* mesh_;
  std::vector<ProjectedVertex> vertices_;
  std::vector<CentreCell> cells_;  ///< of the vertices
};

}  // namespace ocelli
