#include "tests/walkable/walkable_floors.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli::test {

void addBox(Mesh& mesh, const glm::vec3& lower, const glm::vec3& upper) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                                (i & 4) != 0 ? upper.z : lower.z);
  }
  // Each face counter-clockwise from outside.
  for (const glm::uvec4& f : {glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5), glm::uvec4(0, 1, 5, 4),
                              glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6)}) {
    mesh.triangles.emplace_back(first + f.x, first + f.y, first + f.z);
    mesh.triangles.emplace_back(first + f.x, first + f.z, first + f.w);
  }
}

void addFloor(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float top, float thickness) {
  addBox(mesh, {lower.x, top - thickness, lower.y}, {upper.x, top, upper.y});
}

void addWalls(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float height, float floor) {
  constexpr float kThick = 0.2f;
  addBox(mesh, {lower.x - kThick, floor, lower.y - kThick}, {upper.x + kThick, floor + height, lower.y});
  addBox(mesh, {lower.x - kThick, floor, upper.y}, {upper.x + kThick, floor + height, upper.y + kThick});
  addBox(mesh, {lower.x - kThick, floor, lower.y}, {lower.x, floor + height, upper.y});
  addBox(mesh, {upper.x, floor, lower.y}, {upper.x + kThick, floor + height, upper.y});
}

bool holds(const WalkCell& cell, const glm::vec3& point) {
  const glm::vec3 off = point - cell.center;
  const float along = glm::dot(off, cell.axis);
  const float across = glm::dot(off, cell.right());
  const float floor = cell.floorRise * along / (2 * cell.halfLength);
  return std::abs(along) <= cell.halfLength && std::abs(across) <= cell.halfWidth && std::abs(off.y - floor) < 0.5f;
}

int cellAt(const WalkMap& map, const glm::vec3& point) {
  for (size_t i = 0; i < map.cells.size(); ++i) {
    if (holds(map.cells[i], point)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

size_t portalsBetween(const WalkMap& map, int a, int b) {
  size_t count = 0;
  for (const WalkPortal& portal : map.portals) {
    const int from = static_cast<int>(portal.from);
    const int to = static_cast<int>(portal.to);
    count += (from == a && to == b) || (from == b && to == a) ? 1 : 0;
  }
  return count;
}

std::string walkErrorOf(const Mesh& mesh, const WalkOptions& options) {
  try {
    findWalkMap(mesh, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
