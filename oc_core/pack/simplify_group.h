// A coarser form of some triangles, with an error that is measured.
#pragma once

#include <algorithm>
#include <optional>

#include "oc_core/pack/cluster.h"

namespace ocelli {

/// World units.
struct LevelError {
  /// How far any vertex that was there lies from the coarser surface.
  float distance = 0;
  /// Where the colour of such a vertex differs by a share c of full light from that of the coarser surface: c w / 3,
  /// with w the height of the triangle there over its longest side s. The difference vanishes at the corners: two
  /// thirds of c all over the triangle, whose area is s w / 2, are as much as where an edge of full light, as long as
  /// s, is off by so much.
  float color = 0;

  float larger() const { return std::max(distance, color); }
};

struct SimplifiedTriangles {
  WeldedTriangles triangles;
  LevelError error;
};

/// About half as many triangles, whose open edges have the positions of those of `welded`, vertex by vertex: what was
/// next to it still fits. Where vertices at one place have several colours, and so little can be simplified, they get
/// one; that is part of the error. Nothing where it cannot be made to have less than kWorthwhile of its triangles.
std::optional<SimplifiedTriangles> simplified(const WeldedTriangles& welded);

inline constexpr float kWorthwhile = 0.85f;

}  // namespace ocelli
