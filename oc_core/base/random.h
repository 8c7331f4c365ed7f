// Seeded random numbers that are the same with every compiler and library: the distributions of the standard library
// differ between implementations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ocelli {

/// SplitMix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  uint64_t next() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  float inRange(float least, float most) {
    return least + (most - least) * static_cast<float>(static_cast<double>(next() >> 11) * 0x1p-53);
  }

  /// A whole number less than `count`, which is not 0; each is equally likely to within count / 2^64.
  size_t below(size_t count) { return static_cast<size_t>(next() % count); }

  template <class T>
  void shuffle(std::vector<T>& list) {
    for (size_t i = list.size(); i > 1; --i) {
      std::swap(list[i - 1], list[below(i)]);
    }
  }

 private:
  uint64_t state_;
};

}  // namespace ocelli
