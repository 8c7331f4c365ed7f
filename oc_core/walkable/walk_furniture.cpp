#include "oc_core/walkable/walk_furniture.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

namespace ocelli {
namespace {

constexpr float kLowTop = 0.85f;  // of the agent's height: below its eyes
constexpr float kLongest = 5;     // of the agent's height
constexpr float kFence = 0.2f;    // of the agent's height: railings and fences are thinner
constexpr float kWall = 0.4f;     // of the agent's height: walls with windows are thinner

class Furniture {
 public:
  Furniture(const WalkField& field, const WalkColumns& columns, float agentHeight, float stepHeight)
      : field_(field), columns_(columns), agentHeight_(agentHeight), stepHeight_(stepHeight) {}

  WalkField added() {
    grow();
    return joined();
  }

 private:
  size_t cellAt(int x, int z) const { return static_cast<size_t>(z) * columns_.width + x; }

  /// What hangs lowest over a column beside floor of that height, where it holds something low, or floor that was left
  /// out; none where something is as high as the eyes.
  std::optional<float> ceilingOverLow(int x, int z, float floor) const {
    if (x < 0 || z < 0 || x >= columns_.width || z >= columns_.depth) {
      return std::nullopt;
    }
    bool hasGround = false;
    float top = floor - stepHeight_;
    float ceiling = kNoCeiling;
    for (uint32_t s = columns_.first[cellAt(x, z)]; s < columns_.first[cellAt(x, z) + 1]; ++s) {
      const SolidSpan& span = columns_.spans[s];
      if (span.upper < floor - stepHeight_) {
        continue;
      }
      if (span.lower >= floor + agentHeight_ * kLowTop) {
        ceiling = span.lower;
        break;
      }
      hasGround = true;
      top = std::max(top, span.upper);
    }
    return hasGround && top <= floor + agentHeight_ * kLowTop ? std::optional(ceiling) : std::nullopt;
  }

  bool hasSquare(int x, int z, float floor) const {
    const auto range = squaresAt_.find(cellAt(x, z));
    if (range == squaresAt_.end()) {
      return false;
    }
    return std::any_of(range->second.begin(), range->second.end(),
                       [&](float other) { return std::abs(other - floor) < agentHeight_ / 2; });
  }

  /// Gathers what is low, from the floor beside it on.
  void grow() {
    for (const WalkSquare& square : field_.squares) {
      if (std::any_of(square.next.begin(), square.next.end(), [](uint32_t k) { return k == kNoSquare; })) {
        borderSquares_.push_back(&square);
      }
      squaresAt_[cellAt(square.x, square.z)].push_back(square.floor);
    }
    std::vector<uint32_t> front;
    const auto visit = [&](const WalkSquare& from) {
      for (int side = 0; side < 4; ++side) {
        const int x = from.x + kStepX[side];
        const int z = from.z + kStepZ[side];
        if (from.next[side] != kNoSquare || hasSquare(x, z, from.floor)) {
          continue;
        }
        if (const std::optional<float> ceiling = ceilingOverLow(x, z, from.floor)) {
          squaresAt_[cellAt(x, z)].push_back(from.floor);
          WalkSquare square{x, z, from.floor, from.ceiling, from.floor};
          square.isObstacle = true;
          low_.push_back(square);
          ceilings_.push_back(*ceiling);
        }
      }
    };
    for (const WalkSquare* square : borderSquares_) {
      visit(*square);
    }
    for (size_t i = 0; i < low_.size(); ++i) {
      const WalkSquare square = low_[i];  // a copy: the list grows
      visit(square);
    }
  }

  /// Whether two squares side by side are at one height.
  bool fit(const WalkSquare& a, const WalkSquare& b) const { return std::abs(a.floor - b.floor) <= stepHeight_; }

  WalkField joined() {
    WalkField result = field_;
    const auto firstLow = static_cast<uint32_t>(field_.squares.size());
    result.squares.insert(result.squares.end(), low_.begin(), low_.end());
    // By column; there are few on one.
    std::unordered_map<size_t, std::vector<uint32_t>> at;
    for (uint32_t i = 0; i < result.squares.size(); ++i) {
      const WalkSquare& square = result.squares[i];
      const bool isBorder =
          std::any_of(square.next.begin(), square.next.end(), [](uint32_t k) { return k == kNoSquare; });
      if (i >= firstLow || isBorder) {
        at[cellAt(square.x, square.z)].push_back(i);
      }
    }
    for (uint32_t i = firstLow; i < result.squares.size(); ++i) {
      for (int side = 0; side < 4; ++side) {
        const int x = result.squares[i].x + kStepX[side];
        const int z = result.squares[i].z + kStepZ[side];
        if (result.squares[i].next[side] != kNoSquare || x < 0 || z < 0 || x >= columns_.width || z >= columns_.depth) {
          continue;
        }
        const auto others = at.find(cellAt(x, z));
        if (others == at.end()) {
          continue;
        }
        for (const uint32_t k : others->second) {
          if (result.squares[k].next[(side + 2) % 4] == kNoSquare && fit(result.squares[i], result.squares[k])) {
            result.squares[i].next[side] = k;
            result.squares[k].next[(side + 2) % 4] = i;
            break;
          }
        }
      }
    }
    return withoutFences(withoutWindows(result, firstLow), firstLow);
  }

  /// Takes away the low squares in windows: a wall goes on over them.
  WalkField withoutWindows(const WalkField& all, uint32_t firstLow) const {
    std::vector<uint8_t> kept(all.squares.size(), 1);
    for (uint32_t i = firstLow; i < all.squares.size(); ++i) {
      kept[i] = !isWindow(all, i, firstLow, 0) && !isWindow(all, i, firstLow, 1);
    }
    return partOf(all, kept);
  }

  /// Whether a low square stands between two ends of a wall, thinner than walls are, and what hangs over it is lower
  /// than on both sides of that wall. Sides are `side` and the opposite one.
  bool isWindow(const WalkField& all, uint32_t square, uint32_t firstLow, int side) const {
    const int thickest = static_cast<int>(kWall * agentHeight_ / all.cellSize);
    const float lintel = ceilings_[square - firstLow] + all.cellSize;
    const auto isUnderLintel = [&](uint32_t i) {
      return i != kNoSquare && (i < firstLow ? all.squares[i].ceiling : ceilings_[i - firstLow]) <= lintel;
    };
    int length = 1;
    for (const int way : {side, side + 2}) {
      uint32_t i = all.squares[square].next[way];
      for (; isUnderLintel(i) && length <= thickest; i = all.squares[i].next[way]) {
        ++length;
      }
      if (i == kNoSquare || length > thickest) {
        return false;
      }
    }
    for (const int way : {(side + 1) % 4, (side + 3) % 4}) {
      uint32_t i = all.squares[square].next[way];
      while (isUnderLintel(i) && i >= firstLow) {
        i = all.squares[i].next[way];
      }
      if (i != kNoSquare) {
        return false;
      }
    }
    return true;
  }

  /// Takes away the things that are too long or part floor from floor.
  WalkField withoutFences(const WalkField& all, uint32_t firstLow) const {
    std::vector<uint8_t> kept(all.squares.size(), 1);
    std::vector<uint8_t> seen(all.squares.size(), 0);
    for (uint32_t seed = firstLow; seed < all.squares.size(); ++seed) {
      if (seen[seed] != 0) {
        continue;
      }
      std::vector<uint32_t> thing{seed};
      seen[seed] = 1;
      std::vector<uint32_t> beside;  // floor
      for (size_t n = 0; n < thing.size(); ++n) {
        for (const uint32_t k : all.squares[thing[n]].next) {
          if (k == kNoSquare) {
            continue;
          }
          if (k < firstLow) {
            beside.push_back(k);
          } else if (seen[k] == 0) {
            seen[k] = 1;
            thing.push_back(k);
          }
        }
      }
      if (isFence(all, thing, firstLow) || !isFurniture(all, thing, beside)) {
        for (const uint32_t i : thing) {
          kept[i] = 0;
        }
      }
    }
    return partOf(all, kept);
  }

  /// Whether most of it is thin, with floor on both sides.
  bool isFence(const WalkField& all, const std::vector<uint32_t>& thing, uint32_t firstLow) const {
    const int thinnest = static_cast<int>(kFence * agentHeight_ / all.cellSize);
    const auto isThinAt = [&](uint32_t square, int side) {
      int length = 1;
      for (const int way : {side, side + 2}) {
        uint32_t i = all.squares[square].next[way];
        while (i != kNoSquare && i >= firstLow && length <= thinnest) {
          ++length;
          i = all.squares[i].next[way];
        }
        if (i == kNoSquare || i >= firstLow) {
          return false;
        }
      }
      return length <= thinnest;
    };
    const auto thin =
        std::count_if(thing.begin(), thing.end(), [&](uint32_t i) { return isThinAt(i, 0) || isThinAt(i, 1); });
    return 2 * static_cast<size_t>(thin) > thing.size();
  }

  bool isFurniture(const WalkField& all, const std::vector<uint32_t>& thing, std::vector<uint32_t>& beside) const {
    int lowX = all.squares[thing.front()].x;
    int highX = lowX;
    int lowZ = all.squares[thing.front()].z;
    int highZ = lowZ;
    for (const uint32_t i : thing) {
      lowX = std::min(lowX, all.squares[i].x);
      highX = std::max(highX, all.squares[i].x);
      lowZ = std::min(lowZ, all.squares[i].z);
      highZ = std::max(highZ, all.squares[i].z);
    }
    const float size = static_cast<float>(std::max(highX - lowX, highZ - lowZ) + 1) * all.cellSize;
    if (beside.empty() || size > kLongest * agentHeight_) {
      return false;
    }
    // Whether one gets around it, over the floor within a margin.
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    const int margin = static_cast<int>(agentHeight_ / all.cellSize);
    std::unordered_map<uint32_t, bool> reached;  // kept in no order: only looked up
    std::vector<uint32_t> open{beside.front()};
    reached[beside.front()] = true;
    while (!open.empty()) {
      const uint32_t i = open.back();
      open.pop_back();
      for (const uint32_t k : field_.squares[i].next) {
        if (k == kNoSquare || reached.contains(k)) {
          continue;
        }
        const WalkSquare& square = field_.squares[k];
        if (square.x >= lowX - margin && square.x <= highX + margin && square.z >= lowZ - margin &&
            square.z <= highZ + margin) {
          reached[k] = true;
          open.push_back(k);
        }
      }
    }
    return std::all_of(beside.begin(), beside.end(), [&](uint32_t i) { return reached.contains(i); });
  }

  const WalkField& field_;
  const WalkColumns& columns_;
  float agentHeight_;
  float stepHeight_;
  std::vector<const WalkSquare*> borderSquares_;
  std::unordered_map<size_t, std::vector<float>> squaresAt_;  ///< floors of the squares of each column
  std::vector<WalkSquare> low_;
  std::vector<float> ceilings_;  ///< what hangs lowest over each of them
};

}  // namespace

WalkField seenOverFurniture(const WalkField& field, const WalkColumns& columns, float agentHeight, float stepHeight) {
  std::vector<uint32_t> numbers;
  return inOrder(Furniture(field, columns, agentHeight, stepHeight).added(), numbers);
}

}  // namespace ocelli
