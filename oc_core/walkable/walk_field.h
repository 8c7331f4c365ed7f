// The floors of a scene as squares that know their neighbours: a plan that may lie over itself, as storeys do.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_columns.h"

namespace ocelli {

inline constexpr uint32_t kNoSquare = 0xffffffffU;
inline constexpr float kNoCeiling = 1e30f;

/// The sides of a square in turn: -x, +z, +x, -z.
inline constexpr std::array<int, 4> kStepX{-1, 0, 1, 0};
inline constexpr std::array<int, 4> kStepZ{0, 1, 0, -1};

struct WalkSquare {
  int x = 0;  ///< the column of the grid
  int z = 0;
  float floor = 0;
  float ceiling = kNoCeiling;  ///< the lowest thing over it
  float wallTop = 0;  ///< the highest top of what stands beside it, over the sides without neighbour; or `floor`
  std::array<uint32_t, 4> next{kNoSquare, kNoSquare, kNoSquare, kNoSquare};  ///< by side
  bool isObstacle = false;  ///< under a small obstacle that is overlooked (walk_obstacles.h): one cannot stand there
};

/// Squares in order of z, then x, then height.
struct WalkField {
  float cellSize = 1;
  glm::vec2 origin{0};
  std::vector<WalkSquare> squares;

  double area() const { return static_cast<double>(squares.size()) * cellSize * cellSize; }
  /// The neighbour over the corner between `side` and the next one: by both ways round, or none.
  uint32_t diagonal(uint32_t square, int side) const;
};

/// The squares on which someone of that height can stand, joined where one can step from one to the next.
WalkField fieldOf(const WalkColumns& columns, float agentHeight, float stepHeight);

/// Those that are marked, in the same order.
WalkField partOf(const WalkField& field, const std::vector<uint8_t>& kept);

/// Puts squares that were added back in order of z, then x, then height; `numbers` are the new ones of the squares.
WalkField inOrder(const WalkField& field, std::vector<uint32_t>& numbers);

}  // namespace ocelli
