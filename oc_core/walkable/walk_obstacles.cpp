#include "oc_core/walkable/walk_obstacles.h"

#include <algorithm>
#include <map>
#include <utility>

#include "oc_core/walkable/walk_width.h"

namespace ocelli {
namespace {

// How long an obstacle may be, for the width of the space, and for the agent's height.
constexpr double kLowShare = 0.75;
constexpr double kTallShare = 0.35;
constexpr float kLowSize = 3;
constexpr float kTallSize = 1;
constexpr float kEyeShare = 0.9f;  // of the agent's height

struct BorderEdge {
  uint32_t square;
  int side;
};

/// The border of a field once round, from an edge; free floor is on the same hand all along.
std::vector<BorderEdge> borderFrom(const WalkField& field, BorderEdge start, std::vector<uint8_t>& seen) {
  std::vector<BorderEdge> border;
  BorderEdge at = start;
  do {
    const uint32_t next = field.squares[at.square].next[at.side];
    if (next == kNoSquare) {
      seen[at.square] |= static_cast<uint8_t>(1 << at.side);
      border.push_back(at);
      at.side = (at.side + 1) % 4;
    } else {
      at = {next, (at.side + 3) % 4};
    }
  } while (at.square != start.square || at.side != start.side);
  return border;
}

struct Hole {
  std::map<int, std::vector<int>> crossings;  ///< of each row, the x where its borders are
  int width = 0;                              ///< in squares
  int depth = 0;
  bool isInner = false;  ///< else it is the outer border of a part

  int size() const { return std::max(width, depth); }
};

Hole holeOf(const WalkField& field, const std::vector<BorderEdge>& border) {
  Hole hole;
  long doubleArea = 0;
  int lowX = field.squares[border.front().square].x;
  int highX = lowX;
  for (const BorderEdge& edge : border) {
    const WalkSquare& square = field.squares[edge.square];
    // Along the edges of the sides -x and +x, with free floor on the right: positive around a hole.
    if (edge.side == 0 || edge.side == 2) {
      const int x = square.x + (edge.side == 2 ? 1 : 0);
      doubleArea += edge.side == 2 ? -x : x;
      hole.crossings[square.z].push_back(x);
      lowX = std::min(lowX, x);
      highX = std::max(highX, x);
    }
  }
  for (auto& [z, xs] : hole.crossings) {
    std::sort(xs.begin(), xs.end());
  }
  hole.isInner = doubleArea > 0;
  hole.width = highX - lowX;
  hole.depth = hole.crossings.empty() ? 0 : hole.crossings.rbegin()->first - hole.crossings.begin()->first + 1;
  return hole;
}

bool standsHigh(const WalkField& field, const std::vector<BorderEdge>& border, float agentHeight) {
  float top = 0;
  for (const BorderEdge& edge : border) {
    top = std::max(top, field.squares[edge.square].wallTop - field.squares[edge.square].floor);
  }
  return top == 0 || top >= kEyeShare * agentHeight;  // where nothing stands it is a pit
}

/// Adds squares in the hole, and joins them with each other and with its border.
void closeHole(WalkField& field, const std::vector<BorderEdge>& border, const Hole& hole) {
  double floor = 0;
  float ceiling = kNoCeiling;
  for (const BorderEdge& edge : border) {
    floor += field.squares[edge.square].floor;
    ceiling = std::min(ceiling, field.squares[edge.square].ceiling);
  }
  floor /= static_cast<double>(border.size());
  std::map<std::pair<int, int>, uint32_t> added;
  for (const auto& [z, xs] : hole.crossings) {
    for (size_t k = 0; k + 1 < xs.size(); k += 2) {
      for (int x = xs[k]; x < xs[k + 1]; ++x) {
        added[{x, z}] = static_cast<uint32_t>(field.squares.size());
        WalkSquare square{x, z, static_cast<float>(floor), ceiling, static_cast<float>(floor)};
        square.isObstacle = true;
        field.squares.push_back(square);
      }
    }
  }
  const auto join = [&](uint32_t a, int side, uint32_t b) {
    field.squares[a].next[side] = b;
    field.squares[b].next[(side + 2) % 4] = a;
  };
  for (const auto& [at, square] : added) {
    for (const int side : {1, 2}) {
      const auto other = added.find({at.first + kStepX[side], at.second + kStepZ[side]});
      if (other != added.end()) {
        join(square, side, other->second);
      }
    }
  }
  for (const BorderEdge& edge : border) {
    const WalkSquare& square = field.squares[edge.square];
    const auto other = added.find({square.x + kStepX[edge.side], square.z + kStepZ[edge.side]});
    if (other != added.end()) {
      join(edge.square, edge.side, other->second);
    }
  }
}

}  // namespace

WalkField overlookObstacles(const WalkField& field, float agentHeight, uint16_t widest) {
  struct Candidate {
    std::vector<BorderEdge> border;
    Hole hole;
    double share;
  };
  std::vector<Candidate> candidates;
  std::vector<uint8_t> seen(field.squares.size(), 0);  // a bit for each side
  for (uint32_t i = 0; i < field.squares.size(); ++i) {
    for (int side = 0; side < 4; ++side) {
      if (field.squares[i].next[side] != kNoSquare || (seen[i] >> side & 1) != 0) {
        continue;
      }
      std::vector<BorderEdge> border = borderFrom(field, {i, side}, seen);
      const Hole hole = holeOf(field, border);
      const bool isHigh = standsHigh(field, border, agentHeight);
      if (hole.isInner &&
          static_cast<float>(hole.size()) * field.cellSize <= (isHigh ? kTallSize : kLowSize) * agentHeight) {
        candidates.push_back({std::move(border), hole, isHigh ? kTallShare : kLowShare});
      }
    }
  }
  if (candidates.empty()) {
    return field;
  }
  // How wide the space would be without any of them.
  WalkField closed = field;
  for (const Candidate& candidate : candidates) {
    closeHole(closed, candidate.border, candidate.hole);
  }
  std::vector<uint32_t> numbers;
  closed = inOrder(closed, numbers);
  const std::vector<uint16_t> half = halfWidths(closed, stepsToBorder(closed), widest);
  WalkField result = field;
  for (const Candidate& candidate : candidates) {
    int width = 0;
    for (const BorderEdge& edge : candidate.border) {
      width = std::max(width, 2 * half[numbers[edge.square]] - 1);
    }
    if (candidate.hole.size() <= candidate.share * width) {
      closeHole(result, candidate.border, candidate.hole);
    }
  }
  return inOrder(result, numbers);
}

}  // namespace ocelli
