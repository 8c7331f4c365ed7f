#include "oc_core/worlds/panels.h"

#include <array>

#include "oc_core/base/check.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

/// A small fixed number in [0, 1) for brick (i, j), so that bricks differ a little.
float brickNoise(size_t i, size_t j) {
  uint32_t h = static_cast<uint32_t>(i) * 0x9e3779b1u ^ static_cast<uint32_t>(j) * 0x85ebca6bu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

}  // namespace

void addPanel(Mesh& mesh, const std::vector<float>& xs, const std::vector<float>& ys, const glm::mat4& worldFromPanel,
              const std::function<glm::vec3(size_t, size_t)>& color) {
  OC_CHECK(xs.size() >= 2 && ys.size() >= 2, "a panel has at least one cell");
  mesh.colors.resize(mesh.positions.size(), glm::vec3(1));
  for (size_t j = 0; j + 1 < ys.size(); ++j) {
    for (size_t i = 0; i + 1 < xs.size(); ++i) {
      const auto base = static_cast<uint32_t>(mesh.positions.size());
      const std::array<glm::vec2, 4> corners{
          {{xs[i], ys[j]}, {xs[i + 1], ys[j]}, {xs[i + 1], ys[j + 1]}, {xs[i], ys[j + 1]}}};
      for (const glm::vec2& corner : corners) {
        mesh.positions.push_back(glm::vec3(worldFromPanel * glm::vec4(corner, 0, 1)));
      }
      mesh.colors.resize(mesh.positions.size(), color(i, j));
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base, base + 2, base + 3});
    }
  }
}

std::vector<float> evenLines(float first, float last, size_t count) {
  std::vector<float> lines(count + 1);
  for (size_t i = 0; i <= count; ++i) {
    lines[i] = first + (last - first) * static_cast<float>(i) / static_cast<float>(count);
  }
  return lines;
}

void addBrickWall(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float z, size_t rows,
                  size_t bricksInRow) {
  // Lines before and after the mortar: vertical ones at every half brick, because every second row is shifted by half.
  const size_t halves = bricksInRow * 2;
  const float halfBrick = (upper.x - lower.x) / static_cast<float>(halves);
  const float rowHeight = (upper.y - lower.y) / static_cast<float>(rows);
  const float halfMortar = 0.07f * rowHeight;
  std::vector<float> xs{lower.x};
  for (size_t k = 1; k < halves; ++k) {
    const float x = lower.x + halfBrick * static_cast<float>(k);
    xs.push_back(x - halfMortar);
    xs.push_back(x + halfMortar);
  }
  xs.push_back(upper.x);
  std::vector<float> ys{lower.y};
  for (size_t k = 1; k < rows; ++k) {
    const float y = lower.y + rowHeight * static_cast<float>(k);
    ys.push_back(y - halfMortar);
    ys.push_back(y + halfMortar);
  }
  ys.push_back(upper.y);
  // Odd cells are the narrow ones around a line of mortar.
  const auto color = [](size_t i, size_t j) {
    const size_t row = j / 2;
    const size_t line = (i + 1) / 2;  // the half-brick line that a narrow cell surrounds
    if (j % 2 == 1 || (i % 2 == 1 && line % 2 == row % 2)) {
      return palette::mortar();
    }
    const size_t half = i % 2 == 1 ? line : i / 2;
    return palette::brick() * (0.8f + 0.4f * brickNoise((half + row % 2) / 2, row));
  };
  glm::mat4 worldFromPanel(1);
  worldFromPanel[3] = {0, 0, z, 1};
  addPanel(mesh, xs, ys, worldFromPanel, color);
}

void addCheckerFloor(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float y, size_t columns, size_t rows,
                     const glm::vec3& dark, const glm::vec3& light) {
  // Panel (x, y) is world (x, -z), so that its front looks up.
  const glm::mat4 worldFromPanel(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0),
                                 glm::vec4(0, y, 0, 1));
  addPanel(mesh, evenLines(lower.x, upper.x, columns), evenLines(-upper.y, -lower.y, rows), worldFromPanel,
           [&](size_t i, size_t j) { return (i + j) % 2 == 0 ? dark : light; });
}

}  // namespace ocelli
