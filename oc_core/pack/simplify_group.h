// A coarser form of some triangles, with an error that is measured.
#pragma once

#include <optional>

#include "oc_core/pack/cluster.h"
#include "oc_core/pack/place_bits.h"
#include "oc_core/pack/surface_error.h"

namespace ocelli {

struct SimplifiedTriangles {
  WeldedTriangles triangles;
  LevelError error;
};

/// About half as many triangles. Vertices at the places of `shared` stay, and with them the open edges between two of
/// these: what was next to them still fits. Other open edges are rims of the scene, which become coarser as surfaces
/// do. Where vertices at one place have several colours, and so little can be simplified, they get one; that is part of
/// the error. Nothing where it cannot be made to have less than kWorthwhile of its triangles.
std::optional<SimplifiedTriangles> simplified(const WeldedTriangles& welded, const PlaceSet& shared);

inline constexpr float kWorthwhile = 0.85f;

}  // namespace ocelli
