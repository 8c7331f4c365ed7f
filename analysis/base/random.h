// Random numbers that are the same with every compiler and library, which those of <random> are not.
//
//   Blackman and Vigna 2021, "Scrambled linear pseudorandom number generators"   xoshiro256++
//   Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators" splitmix64, which spreads the seeds
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ocelli {

class Random {
 public:
  /// Streams of one seed have nothing to do with each other: each repetition of a simulation takes its own, and threads
  /// may do them in any order.
  explicit Random(uint64_t seed, uint64_t stream = 0);

  uint64_t bits();
  /// Between 0 and 1, never either of them.
  double uniform();
  /// From 0 to `count` - 1, all alike. `count` is positive.
  size_t below(size_t count);
  /// Mean 0, standard deviation 1.
  double normal();

 private:
  std::array<uint64_t, 4> state_{};
};

}  // namespace ocelli
