#include "oc_core/worlds/facade.h"

#include <algorithm>
#include <cmath>

#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {

void addPaintedBox(Mesh& mesh, const glm::vec3& size, const glm::mat4& worldFromBox, const glm::vec3& color) {
  Mesh box = makeBox(size * 0.5f);
  paint(box, color);
  append(mesh, box, worldFromBox);
}

std::vector<float> closerLines(const std::vector<float>& lines, float maxStep) {
  std::vector<float> all;
  for (size_t i = 0; i + 1 < lines.size(); ++i) {
    const auto steps = static_cast<size_t>(std::max(1.0f, std::ceil((lines[i + 1] - lines[i]) / maxStep - 1e-3f)));
    const std::vector<float> between = evenLines(lines[i], lines[i + 1], steps);
    all.insert(all.end(), between.begin(), between.end() - 1);
  }
  all.push_back(lines.back());
  return all;
}

std::vector<size_t> cellsOfLines(const std::vector<float>& lines, const std::vector<float>& closer) {
  std::vector<size_t> cells;
  for (size_t i = 0; i + 1 < closer.size(); ++i) {
    const float middle = (closer[i] + closer[i + 1]) / 2;
    const auto after = std::upper_bound(lines.begin(), lines.end(), middle);
    cells.push_back(static_cast<size_t>(after - lines.begin()) - 1);
  }
  return cells;
}

void addWindow(Mesh& mesh, const WindowOpening& opening, const glm::mat4& worldFromWall, const glm::vec3& color) {
  constexpr float kBoard = 0.1f;
  constexpr float kOut = 0.05f;  // of the frame before the wall
  WallSlab frame;
  frame.thickness = 2 * kOut;
  frame.back = color;
  frame.color = [&](size_t, size_t) { return color; };
  frame.xs = {opening.left - kBoard, opening.left, opening.right, opening.right + kBoard};
  frame.ys = {opening.bottom - kBoard, opening.bottom, opening.top, opening.top + kBoard};
  frame.isOpen = [](size_t i, size_t j) { return i == 1 && j == 1; };
  addSlab(mesh, frame, worldFromWall * placedAt({0, 0, kOut}));
  const glm::vec3 middle((opening.left + opening.right) / 2, (opening.bottom + opening.top) / 2, -0.06f);
  const float width = opening.right - opening.left;
  addPaintedBox(mesh, {0.06f, opening.top - opening.bottom, 0.06f}, worldFromWall * placedAt(middle), color);
  addPaintedBox(mesh, {width, 0.06f, 0.05f}, worldFromWall * placedAt(middle), color);
  addPaintedBox(mesh, {width + 2 * kBoard, 0.06f, 0.16f},
                worldFromWall * placedAt({middle.x, opening.bottom - kBoard - 0.03f, 0.08f}), color * 0.85f);
}

void addDoorFrame(Mesh& mesh, const WindowOpening& opening, float thickness, const glm::mat4& worldFromWall,
                  const glm::vec3& color) {
  constexpr float kBoard = 0.09f;
  WallSlab frame;
  frame.thickness = thickness + 0.06f;
  frame.back = color;
  frame.color = [&](size_t, size_t) { return color; };
  frame.xs = {opening.left - kBoard, opening.left, opening.right, opening.right + kBoard};
  frame.ys = {opening.bottom, opening.top, opening.top + kBoard};
  frame.isOpen = [](size_t i, size_t j) { return i == 1 && j == 0; };
  addSlab(mesh, frame, worldFromWall * placedAt({0, 0, 0.03f}));
}

}  // namespace ocelli
