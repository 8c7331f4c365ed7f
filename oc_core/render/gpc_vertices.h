// The vertices of a mesh in the image of a general pinhole camera, for filling its triangles: placed in runs, zone by
// zone, for the zones that a run's box touches; most runs touch one or none.
#pragma once

#include <span>
#include <vector>

#include "oc_core/render/gpc_raster_zone.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

struct GpcVertex {
  float x = 0;  ///< in the camera's image, pixels
  float y = 0;
  float inverseZ = 0;
  CentreCell cell;
  /// Edges from here within the same part, up to this, squared, are straight but for GpcRasterZone::kChordPixels; -1
  /// where the vertex has no image, or one so far out that triangles are clipped.
  float straightSquared = -1;
  uint32_t part = GpcRasterZone::kAround;
};

/// Whether the edge between two vertices is so short that it is straight whatever its direction.
inline bool isShort(const GpcVertex& a, const GpcVertex& b) {
  const float dx = a.x - b.x;
  const float dy = a.y - b.y;
  return (a.part == b.part) & (dx * dx + dy * dy <= std::min(a.straightSquared, b.straightSquared));
}

class GpcVertices {
 public:
  /// Both must outlive it.
  GpcVertices(std::span<const GpcRasterZone> zones, const ProjectedMesh& projected);

  const GpcVertex& operator[](uint32_t i) const { return vertices_[i]; }
  const GpcBend& bend(uint32_t i) const { return bends_[i]; }
  /// The same for at most GpcRun::kSize points of the pinhole's image.
  void place(std::span<const ProjectedVertex> points, std::span<GpcVertex> placed, std::span<GpcBend> bends) const;

  /// Whether the edge between two vertices, with the bends there, is filled as a straight one.
  bool isStraight(const GpcVertex& a, const GpcBend& bendA, const GpcVertex& b, const GpcBend& bendB) const {
    return isShort(a, b) || (a.part == b.part && GpcRasterZone::isInTransition(a.part) &&
                             std::min(a.straightSquared, b.straightSquared) >= 0 && isHardlyBent(a, bendA, b, bendB));
  }

 private:
  bool isHardlyBent(const GpcVertex& a, const GpcBend& bendA, const GpcVertex& b, const GpcBend& bendB) const {
    const float dx = a.x - b.x;
    const float dy = a.y - b.y;
    const bool isBeside = GpcRasterZone::isBeside(a.part);
    const float along = isBeside ? dx : dy;
    const float across = isBeside ? dy : dx;
    // Half way a chord is an eighth of the second derivative off.
    const auto squared = [&](const GpcBend& bend) {
      const float x = bend.along * along;
      const float y = bend.mixed * across + bend.across * along;
      return (x * x + y * y) * (along * along);
    };
    constexpr auto kMost = static_cast<float>(8 * GpcRasterZone::kChordPixels / GpcRasterZone::kBendMargin);
    return dx * dx + dy * dy <= zones_[a.part / GpcRasterZone::kParts].longestSquared() &&
           std::max(squared(bendA), squared(bendB)) <= kMost * kMost;
  }

  std::span<const GpcRasterZone> zones_;
  glm::vec2 lowest_;  ///< points beyond are clipped
  glm::vec2 highest_;
  std::vector<GpcVertex> vertices_;
  std::vector<GpcBend> bends_;
};

}  // namespace ocelli
