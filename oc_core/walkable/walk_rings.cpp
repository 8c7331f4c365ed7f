#include "oc_core/walkable/walk_rings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ocelli {
namespace {

/// The squares of one piece by their columns.
class PiecePlan {
 public:
  PiecePlan(const WalkField& field, const std::vector<uint32_t>& squares) : field_(field) {
    lowX_ = highX_ = field.squares[squares.front()].x;
    lowZ_ = highZ_ = field.squares[squares.front()].z;
    for (const uint32_t i : squares) {
      lowX_ = std::min(lowX_, field.squares[i].x);
      highX_ = std::max(highX_, field.squares[i].x);
      lowZ_ = std::min(lowZ_, field.squares[i].z);
      highZ_ = std::max(highZ_, field.squares[i].z);
    }
    width_ = highX_ - lowX_ + 1;
    squares_.assign(static_cast<size_t>(width_) * (highZ_ - lowZ_ + 1), kNoSquare);
    for (const uint32_t i : squares) {
      squares_[static_cast<size_t>(field.squares[i].z - lowZ_) * width_ + (field.squares[i].x - lowX_)] = i;
    }
  }

  const WalkSquare* at(const glm::dvec2& p) const {
    const auto x = static_cast<int>(std::floor((p.x - field_.origin.x) / field_.cellSize)) - lowX_;
    const auto z = static_cast<int>(std::floor((p.y - field_.origin.y) / field_.cellSize)) - lowZ_;
    if (x < 0 || z < 0 || x >= width_ || z > highZ_ - lowZ_) {
      return nullptr;
    }
    const uint32_t i = squares_[static_cast<size_t>(z) * width_ + x];
    return i == kNoSquare ? nullptr : &field_.squares[i];
  }

 private:
  const WalkField& field_;
  int lowX_ = 0;
  int highX_ = 0;
  int lowZ_ = 0;
  int highZ_ = 0;
  int width_ = 0;
  std::vector<uint32_t> squares_;
};

WalkRing ringAt(const PiecePlan& plan, const WalkBox& box, double u, double cell, float height) {
  WalkRing ring;
  ring.along = static_cast<float>(u + box.halfLength);
  const double step = cell / 4;
  float ceiling = kNoCeiling;
  float top = 0;
  const auto reach = [&](double sign) {
    int steps = 0;
    while (const WalkSquare* square = plan.at(box.at(u, sign * (steps + 0.5) * step))) {
      ceiling = std::min(ceiling, square->ceiling == kNoCeiling ? kNoCeiling : square->ceiling - square->floor);
      top = std::max(top, square->wallTop - square->floor);
      ++steps;
    }
    return static_cast<float>(steps * step);
  };
  ring.left = reach(-1);
  ring.right = reach(1);
  ring.ceiling = ceiling != kNoCeiling ? ceiling : top > 0 ? top : height;
  if (!(ring.left + ring.right > 0)) {  // the axis is not over the floor here: the tunnel is as its box
    ring.left = ring.right = static_cast<float>(box.halfWidth);
  }
  return ring;
}

/// The largest distance of a ring from the straight line between two others.
float awayFrom(const WalkRing& a, const WalkRing& b, const WalkRing& ring) {
  const float t = b.along > a.along ? (ring.along - a.along) / (b.along - a.along) : 0;
  const auto off = [&](float WalkRing::*value) { return std::abs(a.*value + (b.*value - a.*value) * t - ring.*value); };
  return std::max({off(&WalkRing::left), off(&WalkRing::right), off(&WalkRing::ceiling)});
}

/// Douglas and Peucker's: keeps the rings between two that are kept and away from the line between them.
void keepBetween(const std::vector<WalkRing>& rings, size_t first, size_t last, float tolerance,
                 std::vector<uint8_t>& isKept) {
  std::vector<std::pair<size_t, size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    float most = tolerance;
    size_t farthest = begin;
    for (size_t i = begin + 1; i < end; ++i) {
      const float away = awayFrom(rings[begin], rings[end], rings[i]);
      if (away > most) {
        most = away;
        farthest = i;
      }
    }
    if (farthest != begin) {
      isKept[farthest] = 1;
      open.push_back({begin, farthest});
      open.push_back({farthest, end});
    }
  }
}

}  // namespace

std::vector<WalkRing> ringsOf(const WalkField& field, const std::vector<uint32_t>& squares, const WalkBox& box,
                              float height) {
  const PiecePlan plan(field, squares);
  const double cell = field.cellSize;
  const int count = std::max(1, static_cast<int>(std::lround(2 * box.halfLength / cell)));
  std::vector<WalkRing> rings;
  for (int i = 0; i < count; ++i) {
    rings.push_back(ringAt(plan, box, ((i + 0.5) / count * 2 - 1) * box.halfLength, cell, height));
  }
  // Those of the ends are as those of the first and the last squares.
  rings.insert(rings.begin(), rings.front());
  rings.push_back(rings.back());
  rings.front().along = 0;
  rings.back().along = static_cast<float>(2 * box.halfLength);
  std::vector<uint8_t> isKept(rings.size(), 0);
  isKept.front() = isKept.back() = 1;
  keepBetween(rings, 0, rings.size() - 1, static_cast<float>(1.5 * cell), isKept);
  std::vector<WalkRing> kept;
  for (size_t i = 0; i < rings.size(); ++i) {
    if (isKept[i] != 0) {
      kept.push_back(rings[i]);
    }
  }
  return kept;
}

}  // namespace ocelli
