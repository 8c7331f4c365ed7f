// Random numbers for statistics, the same on every machine: xoshiro256** (Blackman and Vigna 2021), seeded by Random
// (random.h), which is smaller, and is what scenes, orders and tests take.
#pragma once

#include <array>
#include <cstdint>

namespace ocelli {

class RandomNumbers {
 public:
  explicit RandomNumbers(uint64_t seed);
  /// Each part of a work has its own numbers, with any number of threads and in any order: replicate 3 of seed 1.
  RandomNumbers(uint64_t seed, uint64_t part);

  uint64_t bits();
  double uniform();  ///< in [0, 1)
  double normal();   ///< mean 0, standard deviation 1
  /// From 0 to `count` - 1, all alike; `count` is 1 or more.
  uint64_t below(uint64_t count);

 private:
  std::array<uint64_t, 4> state_;
};

}  // namespace ocelli
