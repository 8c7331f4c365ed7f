// Lines as geometry, so that all that takes meshes takes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Straight segments between vertices.
struct LineSet {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;     ///< linear, one a vertex; empty where there are none
  std::vector<glm::uvec2> segments;  ///< two vertices each
};

/// How wide lines are where no one says: this share of the diagonal of the box around what the file has.
inline constexpr double kLineShare = 0.004;

/// Tubes of eight sides around the segments, as wide as `width`. Segments that meet two at a vertex, by less than 90
/// degrees, are one tube, whose rings stand half-way between them; elsewhere each has an end of its own, a cone that
/// reaches half a width beyond the vertex. Segments without a length are left out. The order of the segments says that
/// of the triangles.
///
/// Throws InputError naming `where` for a coordinate that is not finite, and where the mesh would have more than
/// kMaxSceneTriangles. The width must be positive, and each segment name two of the vertices. `sources` gets of each
/// vertex of the mesh the vertex of the lines that it stands around.
Mesh meshOfLines(const LineSet& lines, double width, const std::string& where,
                 std::vector<uint32_t>* sources = nullptr);

}  // namespace ocelli
