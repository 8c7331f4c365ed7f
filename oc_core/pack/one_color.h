// Triangles whose vertices at one place have one colour: a crease that was baked into colours splits vertices, and what
// is split cannot be simplified across.
#pragma once

#include <vector>

#include "oc_core/pack/cluster.h"

namespace ocelli {

struct OneColorTriangles {
  WeldedTriangles triangles;
  /// Of each vertex: by how much the colours that it stands for differ from its own, at most, as a share of full light.
  std::vector<float> spread;
};

/// Equal positions, bit by bit, become one vertex with the mean of their colours. Triangles with two corners at one
/// place are left out.
OneColorTriangles withOneColor(const WeldedTriangles& welded);

}  // namespace ocelli
