#include "oc_core/walkable/walk_width.h"

#include <algorithm>
#include <array>

namespace ocelli {
namespace {

constexpr uint16_t kFarSteps = 0xfffe;

/// All eight neighbours, missing ones as kNoSquare. The first four come before the square in order, but for storeys.
std::array<uint32_t, 8> ring(const WalkField& field, uint32_t i) {
  const auto& next = field.squares[i].next;
  // Sides: 0 is -x, 1 is +z, 2 is +x, 3 is -z.
  return {next[0], field.diagonal(i, 3), next[3], field.diagonal(i, 2),
          next[2], field.diagonal(i, 1), next[1], field.diagonal(i, 0)};
}

}  // namespace

std::vector<uint16_t> stepsToBorder(const WalkField& field, const std::vector<uint32_t>& labels) {
  const auto count = static_cast<uint32_t>(field.squares.size());
  std::vector<uint16_t> steps(count, kFarSteps);
  const auto visit = [&](uint32_t i, int begin) {
    const std::array<uint32_t, 8> around = ring(field, i);
    uint16_t least = steps[i];
    for (int k = begin; k < begin + 4; ++k) {
      const bool isMissing = around[k] == kNoSquare || (!labels.empty() && labels[around[k]] != labels[i]);
      least = std::min<uint16_t>(least, isMissing ? 1 : steps[around[k]] + 1);
    }
    steps[i] = least;
  };
  for (uint32_t i = 0; i < count; ++i) {
    visit(i, 0);
  }
  for (uint32_t i = count; i-- > 0;) {
    visit(i, 4);
  }
  return steps;
}

std::vector<uint16_t> halfWidths(const WalkField& field, std::vector<uint16_t> steps, uint16_t limit) {
  const auto count = static_cast<uint32_t>(field.squares.size());
  std::vector<std::vector<uint32_t>> centers(limit + 1);
  for (uint32_t i = 0; i < count; ++i) {
    steps[i] = std::min(steps[i], limit);
    // A neighbour with one step more covers all that this one does.
    const std::array<uint32_t, 8> around = ring(field, i);
    if (std::none_of(around.begin(), around.end(),
                     [&](uint32_t k) { return k != kNoSquare && std::min(steps[k], limit) == steps[i] + 1; })) {
      centers[steps[i]].push_back(i);
    }
  }
  std::vector<uint16_t> half(count, 0);
  std::vector<uint16_t> visited(count, 0);  // the width at which a square was come to
  std::vector<uint32_t> front;
  std::vector<uint32_t> after;
  for (uint16_t n = limit; n > 0; --n) {
    front = centers[n];
    for (const uint32_t i : front) {
      visited[i] = n;
    }
    for (uint16_t step = 1;; ++step) {
      for (const uint32_t i : front) {
        half[i] = std::max(half[i], n);
      }
      if (step == n || front.empty()) {
        break;
      }
      after.clear();
      for (const uint32_t i : front) {
        for (const uint32_t k : ring(field, i)) {
          if (k != kNoSquare && visited[k] != n) {
            visited[k] = n;
            after.push_back(k);
          }
        }
      }
      std::swap(front, after);
    }
  }
  return half;
}

}  // namespace ocelli
