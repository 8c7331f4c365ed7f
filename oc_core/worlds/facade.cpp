#include "oc_core/worlds/facade.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

// Metres that a frame stands out from the faces of an opening, so that none of its faces lies in one of them.
constexpr float kWithin = 0.01f;

}  // namespace

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
  frame.xs = {opening.left - kBoard, opening.left + kWithin, opening.right - kWithin, opening.right + kBoard};
  frame.ys = {opening.bottom - kBoard, opening.bottom + kWithin, opening.top - kWithin, opening.top + kBoard};
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
  frame.xs = {opening.left - kBoard, opening.left + kWithin, opening.right - kWithin, opening.right + kBoard};
  frame.ys = {opening.bottom, opening.top - kWithin, opening.top + kBoard};
  frame.isOpen = [](size_t i, size_t j) { return i == 1 && j == 0; };
  addSlab(mesh, frame, worldFromWall * placedAt({0, 0, 0.03f}));
}

void addPitchedRoof(Mesh& mesh, const PitchedRoof& roof, const glm::mat4& worldFromRoof) {
  constexpr float kThickness = 0.16f;
  const float half = roof.span / 2;
  const float rise = roof.pitch * half;
  Mesh gable = makePrism({{-half, 0}, {half, 0}, {0, rise}}, roof.length / 2);
  paint(gable, roof.wallColor);
  append(mesh, gable, worldFromRoof);
  const float slope = std::hypot(half, rise);
  const double angle = degreesFromRadians(std::atan2(rise, half));
  for (const bool isUpper : {true, false}) {
    const float end = roof.length / 2 + roof.overGables;
    const float below = (isUpper ? roof.eavesAtUpperX : roof.eavesAtLowerX) * slope / half;
    WallSlab tiles;
    tiles.xs = closerLines({-end, end}, roof.maxCell);
    tiles.ys = closerLines({-below, slope}, roof.maxCell);
    tiles.thickness = kThickness;
    tiles.back = palette::ivory() * 0.7f;
    tiles.color = [&](size_t i, size_t j) {
      return roof.roofColor * ((i + j % 2 * 2) % 4 < 2 ? 1.0f : 0.82f) * (j == 0 ? 0.75f : 1.0f);
    };
    // From the eaves at +x up to the ridge: slab x runs along -z, slab y up the slope, its front looks out. The tiles
    // lie a centimetre over the gable.
    const glm::mat4 roofFromTiles = placedAt({0, 0, 0}, isUpper ? 0 : 180) * placedAt({half, 0.01f, 0}, 90) *
                                    placedAt({0, 0, 0}, angle - 90, {1, 0, 0}) * placedAt({0, 0, kThickness});
    addSlab(mesh, tiles, worldFromRoof * roofFromTiles);
  }
}

}  // namespace ocelli
