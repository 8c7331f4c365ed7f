// The normals of a mesh that mirrors or refracts, smooth between its vertices (section 3.5.2.3.1: normals per pixel).
#pragma once

#include <vector>

#include "oc_core/render/fragment_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// A unit normal for each vertex: the mean of its faces, weighted by their areas; those of vertices at the same place
/// count together where their faces meet at less than the crease angle of shading.h. +y where a vertex has no face
/// with an area.
std::vector<glm::vec3> vertexNormals(const Mesh& mesh);

/// Interpolated at a covered fragment, and turned to the side that `incoming` comes from: by the face, whose side is
/// never in doubt.
glm::vec3 normalAt(const Fragment& fragment, const Mesh& mesh, const std::vector<glm::vec3>& normals,
                   const glm::vec3& incoming);

}  // namespace ocelli
