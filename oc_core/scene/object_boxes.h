// Where the objects of a scene are, and which of its triangles they have.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "oc_core/scene/box.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The box around the triangles of each object. `objectOfTriangle` has one identity for each triangle of `mesh`
/// (GuidedScene, objectOfTriangles()); 0, the structure, is one of them where it has triangles.
std::map<uint32_t, Box> boxesOfObjects(const Mesh& mesh, const std::vector<uint32_t>& objectOfTriangle);

}  // namespace ocelli
