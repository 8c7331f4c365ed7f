#include "oc_core/base/random_numbers.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

uint64_t seedOfPart(uint64_t seed, uint64_t part) {
  return Random(Random(seed).next() ^ part).next();
}

}  // namespace

RandomNumbers::RandomNumbers(uint64_t seed) : state_() {
  Random words(seed);
  for (uint64_t& word : state_) {
    word = words.next();
  }
}

RandomNumbers::RandomNumbers(uint64_t seed, uint64_t part) : RandomNumbers(seedOfPart(seed, part)) {}

uint64_t RandomNumbers::bits() {
  const uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double RandomNumbers::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double RandomNumbers::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

uint64_t RandomNumbers::below(uint64_t count) {
  // What is left over at the end of the range would favour the first numbers.
  const uint64_t leftOver = (0 - count) % count;
  uint64_t drawn = bits();
  while (drawn < leftOver) {
    drawn = bits();
  }
  return drawn % count;
}

}  // namespace ocelli
