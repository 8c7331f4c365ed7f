// Sets that are joined step by step (R. Tarjan, Efficiency of a good but not linear set union algorithm, 1975).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace ocelli {

class DisjointSets {
 public:
  /// Each number below `count` is a set of its own.
  explicit DisjointSets(size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0U); }

  /// Of the set that holds `number`.
  uint32_t least(uint32_t number) {
    while (parents_[number] != number) {
      parents_[number] = parents_[parents_[number]];
      number = parents_[number];
    }
    return number;
  }

  void join(uint32_t a, uint32_t b) {
    a = least(a);
    b = least(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

  /// Makes every least() that follows a single step, until sets are joined again. A parent is never the higher of two
  /// numbers, so one pass does it.
  void flatten() {
    for (uint32_t& parent : parents_) {
      parent = parents_[parent];
    }
  }

 private:
  std::vector<uint32_t> parents_;
};

}  // namespace ocelli
