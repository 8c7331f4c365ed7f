#include "oc_core/worlds/wall_slab.h"

#include <array>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

void addQuad(Mesh& mesh, const std::array<glm::vec3, 4>& corners, const glm::vec3& color,
             const glm::mat4& worldFromSlab) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (const glm::vec3& corner : corners) {
    mesh.positions.push_back(glm::vec3(worldFromSlab * glm::vec4(corner, 1)));
    mesh.colors.push_back(color);
  }
  mesh.triangles.push_back({base, base + 1, base + 2});
  mesh.triangles.push_back({base, base + 2, base + 3});
}

}  // namespace

void addSlab(Mesh& mesh, const WallSlab& slab, const glm::mat4& worldFromSlab) {
  OC_CHECK(slab.xs.size() >= 2 && slab.ys.size() >= 2, "a slab has at least one cell");
  mesh.colors.resize(mesh.positions.size(), glm::vec3(1));
  const size_t columns = slab.xs.size() - 1;
  const size_t rows = slab.ys.size() - 1;
  // Indices wrap round below 0, which is out of range too.
  const auto isFull = [&](size_t i, size_t j) {
    return i < columns && j < rows && !(slab.isOpen && slab.isOpen(i, j));
  };
  const float z = -slab.thickness;
  for (size_t j = 0; j < rows; ++j) {
    for (size_t i = 0; i < columns; ++i) {
      if (!isFull(i, j)) {
        continue;
      }
      const float x0 = slab.xs[i];
      const float x1 = slab.xs[i + 1];
      const float y0 = slab.ys[j];
      const float y1 = slab.ys[j + 1];
      const glm::vec3 color = slab.color(i, j);
      const auto add = [&](const std::array<glm::vec3, 4>& corners, const glm::vec3& c) {
        addQuad(mesh, corners, c, worldFromSlab);
      };
      add({{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}}, color);
      add({{{x1, y0, z}, {x0, y0, z}, {x0, y1, z}, {x1, y1, z}}}, slab.back);
      if (!isFull(i - 1, j)) {
        add({{{x0, y0, z}, {x0, y0, 0}, {x0, y1, 0}, {x0, y1, z}}}, color);
      }
      if (!isFull(i + 1, j)) {
        add({{{x1, y0, 0}, {x1, y0, z}, {x1, y1, z}, {x1, y1, 0}}}, color);
      }
      if (!isFull(i, j - 1)) {
        add({{{x0, y0, z}, {x1, y0, z}, {x1, y0, 0}, {x0, y0, 0}}}, color);
      }
      if (!isFull(i, j + 1)) {
        add({{{x0, y1, 0}, {x1, y1, 0}, {x1, y1, z}, {x0, y1, z}}}, color);
      }
    }
  }
}

}  // namespace ocelli
