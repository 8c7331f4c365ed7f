// Random numbers of simulated subjects.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oc_core/base/random.h"

namespace ocelli {

/// In [0, 1).
inline double uniform(Random& random) {
  return static_cast<double>(random.next() >> 11) * 0x1p-53;
}

inline bool happens(Random& random, double probability) {
  return uniform(random) < probability;
}

/// Box and Muller (1958).
inline double normal(Random& random, double mean, double deviation) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform(random)));
  return mean + deviation * radius * std::cos(2 * std::numbers::pi * uniform(random));
}

/// Normal, but within [least, most].
inline double normalWithin(Random& random, double mean, double deviation, double least, double most) {
  return std::clamp(normal(random, mean, deviation), least, most);
}

/// A seed of its own for part `part` of what `seed` is for.
inline uint64_t seedOf(uint64_t seed, uint64_t part) {
  return Random(seed ^ (part + 1) * 0xd1342543de82ef95u).next();
}

constexpr int64_t nanosecondsOf(double seconds) {
  return static_cast<int64_t>(seconds * 1e9);
}
constexpr double secondsOf(int64_t nanoseconds) {
  return static_cast<double>(nanoseconds) * 1e-9;
}

}  // namespace ocelli
