// Cells of a maze, and the directions that lead from one to the next. Row 0 lies in the north, column 0 in the west.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <string>

namespace ocelli {

enum class Direction : uint8_t { kNorth, kEast, kSouth, kWest };
inline constexpr std::array<Direction, 4> kDirections{Direction::kNorth, Direction::kEast, Direction::kSouth,
                                                      Direction::kWest};

Direction leftOf(Direction direction);
Direction rightOf(Direction direction);
Direction opposite(Direction direction);
bool isEastWest(Direction direction);
const char* nameOf(Direction direction);

/// From a cell to its neighbour: one of the two is 0, the other 1 or -1.
struct CellStep {
  int rows = 0;     ///< to the south
  int columns = 0;  ///< to the east
};
CellStep stepOf(Direction direction);

struct MazeCell {
  int row = 0;
  int column = 0;

  MazeCell neighbor(Direction direction) const;
  auto operator<=>(const MazeCell&) const = default;
};

/// "(row 2, column 5)".
std::string nameOf(const MazeCell& cell);

}  // namespace ocelli
