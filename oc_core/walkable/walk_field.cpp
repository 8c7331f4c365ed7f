#include "oc_core/walkable/walk_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ocelli {
namespace {

/// Sets what stands beside each square, over the sides where it has no neighbour.
void measureWalls(const WalkColumns& columns, WalkField& field) {
  for (WalkSquare& square : field.squares) {
    square.wallTop = square.floor;
    for (int side = 0; side < 4; ++side) {
      const int x = square.x + kStepX[side];
      const int z = square.z + kStepZ[side];
      if (square.next[side] != kNoSquare || x < 0 || z < 0 || x >= columns.width || z >= columns.depth) {
        continue;
      }
      const size_t cell = static_cast<size_t>(z) * columns.width + x;
      for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
        if (columns.spans[s].lower < square.ceiling) {
          square.wallTop = std::max(square.wallTop, std::min(columns.spans[s].upper, square.ceiling));
        }
      }
    }
  }
}

/// Marks the spans that one can stand on: floors, and the edges of steps and kerbs, which may fill a column alone.
/// These have floor on opposite sides, of which both are within a step.
std::vector<uint8_t> standingSpans(const WalkColumns& columns, float agentHeight, float stepHeight) {
  std::vector<uint8_t> isStanding(columns.spans.size(), 0);
  std::vector<uint8_t> hasRoom(columns.spans.size(), 0);
  const size_t cells = static_cast<size_t>(columns.width) * columns.depth;
  for (size_t cell = 0; cell < cells; ++cell) {
    for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
      const float ceiling = s + 1 < columns.first[cell + 1] ? columns.spans[s + 1].lower : kNoCeiling;
      hasRoom[s] = ceiling - columns.spans[s].upper >= agentHeight ? 1 : 0;
      isStanding[s] = columns.spans[s].isFloor ? hasRoom[s] : 0;
    }
  }
  const auto hasFloor = [&](int x, int z, float height) {
    if (x < 0 || z < 0 || x >= columns.width || z >= columns.depth) {
      return false;
    }
    const size_t cell = static_cast<size_t>(z) * columns.width + x;
    for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
      if (columns.spans[s].isFloor && hasRoom[s] != 0 && std::abs(columns.spans[s].upper - height) <= stepHeight) {
        return true;
      }
    }
    return false;
  };
  for (int z = 0; z < columns.depth; ++z) {
    for (int x = 0; x < columns.width; ++x) {
      const size_t cell = static_cast<size_t>(z) * columns.width + x;
      for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
        const SolidSpan& span = columns.spans[s];
        if (!span.isFloor && hasRoom[s] != 0 &&
            ((hasFloor(x - 1, z, span.upper) && hasFloor(x + 1, z, span.upper)) ||
             (hasFloor(x, z - 1, span.upper) && hasFloor(x, z + 1, span.upper)))) {
          isStanding[s] = 1;
        }
      }
    }
  }
  return isStanding;
}

}  // namespace

uint32_t WalkField::diagonal(uint32_t square, int side) const {
  const int other = (side + 1) % 4;
  const uint32_t a = squares[square].next[side];
  const uint32_t b = squares[square].next[other];
  if (a == kNoSquare || b == kNoSquare) {
    return kNoSquare;
  }
  const uint32_t corner = squares[a].next[other];
  return corner == squares[b].next[side] ? corner : kNoSquare;
}

WalkField fieldOf(const WalkColumns& columns, float agentHeight, float stepHeight) {
  WalkField field;
  field.cellSize = columns.cellSize;
  field.origin = columns.origin;
  const std::vector<uint8_t> isStanding = standingSpans(columns, agentHeight, stepHeight);
  std::vector<uint32_t> first(columns.first.size());
  for (int z = 0; z < columns.depth; ++z) {
    for (int x = 0; x < columns.width; ++x) {
      const size_t cell = static_cast<size_t>(z) * columns.width + x;
      first[cell] = static_cast<uint32_t>(field.squares.size());
      for (uint32_t s = columns.first[cell]; s < columns.first[cell + 1]; ++s) {
        const float ceiling = s + 1 < columns.first[cell + 1] ? columns.spans[s + 1].lower : kNoCeiling;
        if (isStanding[s] != 0) {
          field.squares.push_back({x, z, columns.spans[s].upper, ceiling});
        }
      }
    }
  }
  first.back() = static_cast<uint32_t>(field.squares.size());

  // Each square takes the neighbour that is nearest in height; both must agree.
  const auto nearest = [&](const WalkSquare& square, int side) {
    const int x = square.x + kStepX[side];
    const int z = square.z + kStepZ[side];
    uint32_t found = kNoSquare;
    if (x < 0 || z < 0 || x >= columns.width || z >= columns.depth) {
      return found;
    }
    const size_t cell = static_cast<size_t>(z) * columns.width + x;
    float least = stepHeight;
    for (uint32_t s = first[cell]; s < first[cell + 1]; ++s) {
      const WalkSquare& other = field.squares[s];
      const float rise = std::abs(other.floor - square.floor);
      const float room = std::min(other.ceiling, square.ceiling) - std::max(other.floor, square.floor);
      if (rise <= least && room >= agentHeight) {
        least = rise;
        found = s;
      }
    }
    return found;
  };
  for (WalkSquare& square : field.squares) {
    for (int side = 0; side < 4; ++side) {
      square.next[side] = nearest(square, side);
    }
  }
  for (uint32_t i = 0; i < field.squares.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      uint32_t& next = field.squares[i].next[side];
      if (next != kNoSquare && field.squares[next].next[(side + 2) % 4] != i) {
        next = kNoSquare;
      }
    }
  }
  measureWalls(columns, field);
  return field;
}

WalkField partOf(const WalkField& field, const std::vector<uint8_t>& kept) {
  WalkField part;
  part.cellSize = field.cellSize;
  part.origin = field.origin;
  std::vector<uint32_t> numbers(field.squares.size(), kNoSquare);
  for (uint32_t i = 0; i < numbers.size(); ++i) {
    if (kept[i] != 0) {
      numbers[i] = static_cast<uint32_t>(part.squares.size());
      part.squares.push_back(field.squares[i]);
    }
  }
  for (WalkSquare& square : part.squares) {
    for (uint32_t& next : square.next) {
      next = next == kNoSquare ? kNoSquare : numbers[next];
    }
  }
  return part;
}

WalkField inOrder(const WalkField& field, std::vector<uint32_t>& numbers) {
  std::vector<uint32_t> order(field.squares.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const WalkSquare& p = field.squares[a];
    const WalkSquare& q = field.squares[b];
    return std::tie(p.z, p.x, p.floor) < std::tie(q.z, q.x, q.floor);
  });
  numbers.assign(order.size(), 0);
  WalkField result;
  result.cellSize = field.cellSize;
  result.origin = field.origin;
  for (uint32_t i = 0; i < order.size(); ++i) {
    numbers[order[i]] = i;
    result.squares.push_back(field.squares[order[i]]);
  }
  for (WalkSquare& square : result.squares) {
    for (uint32_t& next : square.next) {
      next = next == kNoSquare ? kNoSquare : numbers[next];
    }
  }
  return result;
}

}  // namespace ocelli
