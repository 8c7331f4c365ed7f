#include "analysis/base/random.h"

#include <bit>
#include <cmath>
#include <limits>

namespace ocelli {
namespace {

uint64_t splitmix(uint64_t& state) {
  state += 0x9e3779b97f4a7c15U;
  uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(uint64_t seed, uint64_t stream) {
  uint64_t mixed = stream;
  uint64_t state = seed ^ splitmix(mixed);
  for (uint64_t& word : state_) {
    word = splitmix(state);
  }
}

uint64_t Random::bits() {
  const uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() {
  return (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52;
}

size_t Random::below(size_t count) {
  // Values beyond the last whole multiple would favour the small numbers.
  const uint64_t whole = std::numeric_limits<uint64_t>::max() / count * count;
  uint64_t value = bits();
  while (value >= whole) {
    value = bits();
  }
  return value % count;
}

double Random::normal() {
  // Marsaglia's polar method, which needs no trigonometry; the second number of the pair is let go.
  while (true) {
    const double x = 2 * uniform() - 1;
    const double y = 2 * uniform() - 1;
    const double square = x * x + y * y;
    if (square < 1) {
      return x * std::sqrt(-2 * std::log(square) / square);
    }
  }
}

}  // namespace ocelli
