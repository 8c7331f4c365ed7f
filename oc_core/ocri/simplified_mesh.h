// The scene itself with fewer triangles: what a user has who brings its size down before slicing instead of taking an
// image of it. The work is done by meshoptimizer.
#pragma once

#include <cstddef>

#include "oc_core/scene/mesh.h"

namespace ocelli {

enum class SimplifyMethod {
  kTopological,  ///< meshopt_simplify: collapses edges and keeps the topology, so it may stop early
  kSloppy,       ///< meshopt_simplifySloppy: clusters vertices; faster, and closes holes and thin gaps
};

struct SimplifiedMesh {
  Mesh mesh;
  size_t targetTriangles = 0;
  float error = 0;  ///< of the surface, as meshoptimizer estimates it, in the units of the scene

  /// False where topology stood in the way. kSloppy may fall short of the target by much, but never exceeds it.
  bool reachedTarget() const { return mesh.triangles.size() <= targetTriangles; }
};

/// At most `targetTriangles` triangles where the method can. Vertices that are equal in position and colour are merged
/// first: triangles that share none cannot be simplified. Those that are left keep place and colour. Throws InputError
/// for a target of 0 and for a mesh without triangles.
SimplifiedMesh simplifyMesh(const Mesh& mesh, size_t targetTriangles, SimplifyMethod method);

}  // namespace ocelli
