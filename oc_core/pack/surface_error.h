// How far a coarser surface is off, at the vertices of the finer one: in place and in colour.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "oc_core/pack/cluster.h"

namespace ocelli {

/// World units.
struct LevelError {
  /// How far any vertex that was there lies from the coarser surface, and any of a rim from the coarser rim
  /// (rim_error.h).
  float distance = 0;
  /// Where the colour of such a vertex differs by a share c of full light from that of the coarser surface: c w / 3,
  /// with w the height of the triangle there over its longest side s. The difference vanishes at the corners: two
  /// thirds of c all over the triangle, whose area is s w / 2, are as much as where an edge of full light, as long as
  /// s, is off by so much.
  float color = 0;

  float larger() const { return std::max(distance, color); }
};

/// Of both the larger ones.
inline LevelError largest(const LevelError& a, const LevelError& b) {
  return {std::max(a.distance, b.distance), std::max(a.color, b.color)};
}

/// Coarser triangles over the vertices of finer ones. For one thread.
class CoarseSurface {
 public:
  /// `spread`: by how much the colour of each vertex of `fine` is off by itself; empty where none is. Both must outlive
  /// this.
  CoarseSurface(const WeldedTriangles& fine, std::span<const uint32_t> coarse, std::span<const float> spread);

  /// Of a vertex that no coarser triangle has. Where a crease or a colour meets a vertex there are several surfaces as
  /// near, or nearly: it counts as the one that fits best in place and colour together.
  LevelError errorAt(uint32_t vertex) const;

  /// What the vertices that are left are off by, as they stand for several colours.
  LevelError spreadError() const;

 private:
  struct Facet {
    uint32_t a = 0;
    uint32_t b = 0;
    uint32_t c = 0;
    float height = 0;  ///< over its longest side
  };
  /// Spheres around the facets, one number after the other: they tell that most facets are too far away.
  struct Bounds {
    std::vector<float> x;
    std::vector<float> y;
    std::vector<float> z;
    std::vector<float> radius;
  };

  LevelError errorAgainst(const Facet& facet, uint32_t vertex) const;
  float spreadOf(uint32_t vertex) const { return spread_.empty() ? 0 : spread_[vertex]; }

  const WeldedTriangles& fine_;
  std::span<const float> spread_;
  std::vector<Facet> facets_;
  Bounds bounds_;
  mutable std::vector<float> distances2_;  ///< of a vertex to the middles of the spheres
};

}  // namespace ocelli
