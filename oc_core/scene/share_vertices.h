// Vertex sharing: many formats repeat a vertex for each of its triangles.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Merges vertices that are equal bit by bit in position and colour, and drops those that no triangle uses. Vertices
/// keep the order in which the triangles first use them. Every index must be in range.
void shareVertices(Mesh& mesh);

/// Drops the vertices that no triangle uses, and does nothing where there is none. Vertices keep their order.
void dropUnusedVertices(Mesh& mesh);

}  // namespace ocelli
