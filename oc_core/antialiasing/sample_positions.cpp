#include "oc_core/antialiasing/sample_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// A number in [0, 1) that depends on all bits of all arguments (the finaliser of splitmix64).
double hashedShare(uint64_t a, uint64_t b, uint64_t c) {
  uint64_t x = (a << 40) ^ (b << 20) ^ c;
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  x ^= x >> 31;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

glm::dvec2 middleOfStratum(int /*i*/, int /*k*/, int /*n*/, uint32_t /*pattern*/) {
  return glm::dvec2(0.5);
}

glm::dvec2 shearedInStratum(int i, int k, int n, uint32_t /*pattern*/) {
  return {(k + 0.5) / n, (i + 0.5) / n};
}

glm::dvec2 anywhereInStratum(int i, int k, int n, uint32_t pattern) {
  const auto stratum = static_cast<uint64_t>(k * n + i);
  return {hashedShare(pattern, stratum, 0), hashedShare(pattern, stratum, 1)};
}

/// Where element i of n goes in a permutation of that number (Kensler, "Correlated Multi-Jittered Sampling", Pixar
/// technical memo 13-01, 2013).
uint32_t permuted(uint32_t i, uint32_t n, uint32_t permutation) {
  uint32_t w = n - 1;
  for (const int shift : {1, 2, 4, 8, 16}) {
    w |= w >> shift;
  }
  do {
    i ^= permutation;
    i *= 0xe170893du;
    i ^= permutation >> 16;
    i ^= (i & w) >> 4;
    i ^= permutation >> 8;
    i *= 0x0929eb3fu;
    i ^= permutation >> 23;
    i ^= (i & w) >> 1;
    i *= 1 | permutation >> 27;
    i *= 0x6935fa69u;
    i ^= (i & w) >> 11;
    i *= 0x74dcb303u;
    i ^= (i & w) >> 2;
    i *= 0x9e501cc3u;
    i ^= (i & w) >> 2;
    i *= 0xc860a3dfu;
    i &= w;
    i ^= i >> 5;
  } while (i >= n);
  return (i + permutation) % n;
}

glm::dvec2 multiJitteredInStratum(int i, int k, int n, uint32_t pattern) {
  const auto count = static_cast<uint32_t>(n);
  const uint32_t column = permuted(static_cast<uint32_t>(k), count, pattern * 0xa511e9b3u + 0x51633e2du);
  const uint32_t row = permuted(static_cast<uint32_t>(i), count, pattern * 0x63d83595u + 0x68bc21ebu);
  return {(column + 0.5) / n, (row + 0.5) / n};
}

/// Rows are shifted by multiples of about the golden section, so that neighbours lie far apart.
glm::dvec2 slantedInStratum(int i, int k, int n, uint32_t /*pattern*/) {
  int step = std::max(static_cast<int>(std::lround(0.618 * n)), 1);
  while (std::gcd(step, n) > 1) {
    ++step;
  }
  const double offset = (k * step % n + 0.5) / n;
  return {offset, (i + offset) / n};
}

constexpr std::array<SamplePlacement, 5> kPlacements = {{
    {"grid", "in the middle of its stratum, as one image of a higher resolution", &middleOfStratum, false},
    {"sheared", "a grid sheared along both axes: each sample has a row and a column of its own", &shearedInStratum,
     false},
    {"slanted",
     "on rows that slant from one stratum to the next: each sample has a row and a column of its own, and small "
     "triangles take the least time",
     &slantedInStratum, false, true},
    {"multijittered", "each sample has a row and a column of its own, which differ from pixel to pixel in their order",
     &multiJitteredInStratum, true},
    {"jittered", "anywhere in its stratum, otherwise in each pixel", &anywhereInStratum, true},
}};

constexpr std::array<glm::ivec2, 2> kTwo = {{{4, 4}, {-4, -4}}};
constexpr std::array<glm::ivec2, 4> kFour = {{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
constexpr std::array<glm::ivec2, 8> kEight = {{{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
constexpr std::array<glm::ivec2, 16> kSixteen = {{{1, 1},
                                                  {-1, -3},
                                                  {-3, 2},
                                                  {4, -1},
                                                  {-5, -2},
                                                  {2, 5},
                                                  {5, 3},
                                                  {3, -5},
                                                  {-2, 6},
                                                  {0, -7},
                                                  {-4, -6},
                                                  {-6, 4},
                                                  {-8, 0},
                                                  {7, -4},
                                                  {6, 7},
                                                  {-7, -8}}};

}  // namespace

std::span<const SamplePlacement> samplePlacements() {
  return kPlacements;
}

const SamplePlacement* findSamplePlacement(const std::string& name) {
  const auto found = std::find_if(kPlacements.begin(), kPlacements.end(),
                                  [&](const SamplePlacement& each) { return std::string_view(each.name) == name; });
  return found != kPlacements.end() ? &*found : nullptr;
}

std::span<const glm::ivec2> multisamplePositions(int samples) {
  switch (samples) {
    case 2:
      return kTwo;
    case 4:
      return kFour;
    case 8:
      return kEight;
    case 16:
      return kSixteen;
    default:
      return {};
  }
}

SamplePattern::SamplePattern(int n, const SamplePlacement& placement)
    : columns_(n), rows_(n), slanted_(placement.hasSlantedRows) {
  OC_CHECK(n >= 1 && n <= kMaxSide, "no such number of samples");
  constexpr size_t kVaried = 64;
  patterns_.resize(placement.varies ? kVaried : 1);
  least_ = 1;
  greatest_ = 0;
  for (uint32_t pattern = 0; pattern < patterns_.size(); ++pattern) {
    Offsets& offsets = patterns_[pattern];
    for (int k = 0; k < n; ++k) {
      for (int i = 0; i < n; ++i) {
        const glm::dvec2 in = placement.inStratum(i, k, n, pattern);
        offsets.u.push_back(std::min(static_cast<float>((i + in.x) / n), 1 - 0x1p-24f));
        offsets.v.push_back(std::min(static_cast<float>((k + in.y) / n), 1 - 0x1p-24f));
        least_ = std::min(least_, static_cast<float>(std::min(in.x, in.y)));
        greatest_ = std::max(greatest_, static_cast<float>(std::max(in.x, in.y)));
      }
    }
  }
}

SamplePattern SamplePattern::multisample(int samples) {
  const std::span<const glm::ivec2> positions = multisamplePositions(samples);
  OC_CHECK(!positions.empty(), "multisampling has not so many samples");
  SamplePattern pattern;
  pattern.columns_ = samples;
  pattern.stratified_ = false;
  pattern.patterns_.resize(1);
  for (const glm::ivec2& each : positions) {
    pattern.patterns_[0].u.push_back(0.5f + static_cast<float>(each.x) / 16);
    pattern.patterns_[0].v.push_back(0.5f + static_cast<float>(each.y) / 16);
  }
  return pattern;
}

const SamplePattern::Offsets& SamplePattern::patternAt(int pixelX, int pixelY) const {
  if (patterns_.size() == 1) {
    return patterns_[0];
  }
  uint32_t mixed = static_cast<uint32_t>(pixelX) * 0x9e3779b1u ^ static_cast<uint32_t>(pixelY) * 0x85ebca77u;
  mixed ^= mixed >> 15;
  mixed *= 0x2c1b3c6du;
  mixed ^= mixed >> 13;
  return patterns_[mixed & (patterns_.size() - 1)];
}

}  // namespace ocelli
