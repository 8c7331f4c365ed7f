// The grid of voxels that multivox displays show: cells in a box, one byte of colour each.
//
// Where a cell is in model space (y up, the viewer in front at +z): the grid is turned, not mirrored, such that its z
// is up and an observer in front of the display, as its simulator begins, sees x go right and y go away. Grid axes in
// model space: x = (1, 0, 0), y = (0, 0, -1), z = (0, 1, 0). Cells are cubes. The circle of radius 1 about the axis
// just fits into the grid's square of x and y; the grid's middle is the model's.
//
// A colour is RGB332: red in bits 7 to 5, green in 4 to 2, blue in 1 and 0, levels in equal steps of light. A display
// shows the highest one to three bits of each channel, as its `bits per channel` says (blue has two at most).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/fwd.hpp>
#include <glm/vec3.hpp>

namespace ocelli {

struct VoxelGrid {
  int x = 128;
  int y = 128;
  int z = 64;

  size_t cells() const { return static_cast<size_t>(x) * static_cast<size_t>(y) * static_cast<size_t>(z); }
  /// z fastest, then x: the columns of cells along the axis lie one after the other.
  size_t index(int cellX, int cellY, int cellZ) const { return static_cast<size_t>((cellY * x + cellX) * z + cellZ); }
  size_t columns() const { return static_cast<size_t>(x) * static_cast<size_t>(y); }

  /// In radii of the display.
  double cellSize() const { return 2.0 / (x < y ? x : y); }
  double halfHeight() const { return z * cellSize() / 2; }
  /// Grid coordinates of a model point: cell (i, j, k) is [i, i + 1) x [j, j + 1) x [k, k + 1).
  glm::dvec3 gridFromModel(const glm::dvec3& p) const {
    return {p.x / cellSize() + x / 2.0, -p.z / cellSize() + y / 2.0, p.y / cellSize() + z / 2.0};
  }
  glm::dvec3 cellCenter(int cellX, int cellY, int cellZ) const {
    return {(cellX + 0.5 - x / 2.0) * cellSize(), (cellZ + 0.5 - z / 2.0) * cellSize(),
            -(cellY + 0.5 - y / 2.0) * cellSize()};
  }

  bool operator==(const VoxelGrid&) const = default;
};

inline constexpr int kMaxShownBits = 3;

/// Light of the three channels as shares of `full` (0 to full), rounded to the levels of a display that shows so many
/// bits of each channel. Full light sets all bits; the bits that are not shown repeat those that are, so that more bits
/// show about the same. What has any light never becomes dark: where all channels would round to 0, those with the most
/// light get the lowest level that is not.
uint8_t rgb332(const glm::u64vec3& light, uint64_t full, int shownBits);

/// Levels of the shown bits of a colour, in equal steps of light.
struct ShownLevels {
  glm::ivec3 level;
  glm::ivec3 full;  ///< the highest level of each channel
};
ShownLevels shownLevels(uint8_t color, int shownBits);

}  // namespace ocelli
