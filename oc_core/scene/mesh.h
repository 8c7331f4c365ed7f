// A triangle mesh with a colour at each vertex: what every renderer and the slicer take.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/scene/box.h"

namespace ocelli {

struct Mesh {
  std::vector<glm::vec3> positions;   ///< world coordinates
  std::vector<glm::vec3> colors;      ///< linear RGB in [0, 1], one a vertex; empty means white
  std::vector<glm::uvec3> triangles;  ///< vertex indices; counter-clockwise seen from outside, though nothing culls
  /// Only what some viewpoints need of a scene: its surfaces end anywhere, so that it does not tell what is inside of
  /// objects.
  bool isPart = false;
  /// Made of samples of several images: where these overlap, surfaces lie on each other that are one and the same.
  bool isSampled = false;

  bool empty() const { return triangles.empty(); }
  glm::vec3 color(uint32_t vertex) const { return colors.empty() ? glm::vec3(1) : colors[vertex]; }
};

Box boundsOf(const Mesh& mesh);

/// Appends `part`, moved by `worldFromPart`, to `mesh`. Fills in white where only one of them has colours. A mirroring
/// transform reverses the triangles, so that outside stays outside.
void append(Mesh& mesh, const Mesh& part, const glm::mat4& worldFromPart = glm::mat4(1));

/// Throws InputError naming the first NaN or infinite coordinate, out-of-range index, or colour count mismatch, and
/// where there is no triangle. `where` is the file or scene the mesh came from.
void validate(const Mesh& mesh, const std::string& where);

}  // namespace ocelli
