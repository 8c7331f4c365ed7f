// Masks of alpha as geometry: what a mask leaves out is cut away, so that all that takes meshes sees through it.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// A vertex that stands on an edge: at `low` where `share` is 0, at `high` where it is 1.
struct EdgeVertex {
  uint32_t low = 0;
  uint32_t high = 0;
  float share = 0.5f;
};

/// Keeps of each triangle the part where `values`, one a vertex and linear in between, are `least` or more. Vertices on
/// edges are added at the end, one an edge, with interpolated colours; returns how they stand. Vertices that are no
/// longer used stay. Triangles that lie side by side stay so: there are no gaps along their edges.
std::vector<EdgeVertex> cutAway(Mesh& mesh, const std::vector<float>& values, float least);

}  // namespace ocelli
