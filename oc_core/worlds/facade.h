// What houses of several made scenes are built of: painted boxes, lines that are close enough, windows.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// A closed box of one colour, `size` long along each axis, around the origin of `worldFromBox`.
void addPaintedBox(Mesh& mesh, const glm::vec3& size, const glm::mat4& worldFromBox, const glm::vec3& color);

/// The lines (ascending, two or more) and as few even ones between each two neighbours as leave no step over `maxStep`.
std::vector<float> closerLines(const std::vector<float>& lines, float maxStep);
/// The one of `lines` just before or at each of the cells of closerLines(): of cell i between refined lines.
std::vector<size_t> cellsOfLines(const std::vector<float>& lines, const std::vector<float>& closer);

/// Of the rectangle between two corners of an opening, in the plane z = 0 of a wall whose outside is +z.
struct WindowOpening {
  float left, right, bottom, top;
};

/// A frame around it that stands out by `depth`, a cross of bars within it, and a sill, all closed solids.
void addWindow(Mesh& mesh, const WindowOpening& opening, const glm::mat4& worldFromWall, const glm::vec3& color);
/// A frame left, right and on top of a doorway through a wall that is `thickness` thick.
void addDoorFrame(Mesh& mesh, const WindowOpening& opening, float thickness, const glm::mat4& worldFromWall,
                  const glm::vec3& color);

/// Tiles on both slopes over a gable whose ridge runs along z; its foot is the plane y = 0.
struct PitchedRoof {
  float span = 8;              ///< across the ridge
  float length = 8;            ///< along it
  float pitch = 0.85f;         ///< height, of half the span
  float eavesAtLowerX = 0.3f;  ///< how far, level, the tiles go beyond the foot
  float eavesAtUpperX = 0.3f;
  float overGables = 0;  ///< how far they go beyond both ends
  float maxCell = 1;
  glm::vec3 wallColor{1};
  glm::vec3 roofColor{1};
};
void addPitchedRoof(Mesh& mesh, const PitchedRoof& roof, const glm::mat4& worldFromRoof);

}  // namespace ocelli
