// How a scene is cut into parts that fit into memory: cells of an octree, each with a bounded number of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "oc_core/pack/triangle_source.h"
#include "oc_core/scene/box.h"

namespace ocelli {

/// Cells of a grid of 128^3 in Morton order, which make one part each or together with others.
struct ScenePart {
  uint32_t firstCell = 0;
  uint32_t endCell = 0;
  uint64_t triangles = 0;
  uint64_t firstTriangle = 0;      ///< of a part without children: where its triangles stand, sorted by part
  std::vector<uint32_t> children;  ///< indices of parts, all less than its own
};

struct ScenePlan {
  static constexpr uint64_t kPartTriangles = 400'000;  ///< of a part without children, where its cells allow
  static constexpr uint32_t kCellsPerAxis = 128;

  Box box;
  uint64_t triangles = 0;
  std::vector<ScenePart> parts;  ///< children before parents; the last one is all of the scene

  /// By the middle of its box.
  uint32_t cellOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) const;
  /// Whether a triangle and so its middle lie in one cell.
  bool isWithinOneCell(const std::array<glm::vec3, 3>& corners) const;
  /// The part without children of a cell.
  uint32_t partOf(uint32_t cell) const { return partOfCell[cell]; }
  std::vector<uint32_t> partOfCell;

 private:
  glm::uvec3 cellAt(const glm::dvec3& point) const;
};

/// Goes through the source twice. Throws InputError naming `where` where it has no triangle, or more than the file can
/// tell apart.
ScenePlan planOf(const TriangleSource& source, const std::string& where);

}  // namespace ocelli
