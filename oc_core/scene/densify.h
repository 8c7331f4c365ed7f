// More triangles for the same surface: what the measurements on large scenes need.
#pragma once

#include <cstddef>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Splits edges at their midpoints until `mesh` has `triangles` triangles, one more, or what it has already. Whole
/// rounds turn each triangle into four; the last round splits the longest edges only. Both triangles at an edge split
/// it alike, so no crack opens, and the surface stays the same, flat faces included. Colours are interpolated.
void densify(Mesh& mesh, size_t triangles);

}  // namespace ocelli
