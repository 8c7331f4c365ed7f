// Noise for textures that code makes: the same numbers with every compiler, from whole-number hashes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

namespace ocelli {

/// A number in [0, 1) of a lattice point.
inline float latticeNoise(int x, int y, uint32_t seed) {
  uint32_t h = static_cast<uint32_t>(x) * 0x9e3779b1u ^ static_cast<uint32_t>(y) * 0x85ebca6bu ^ seed * 0xc2b2ae35u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<float>((h ^ (h >> 15)) >> 8) / 16777216.0f;
}

/// Smooth noise in [0, 1) with bumps about one unit wide.
inline float smoothNoise(const glm::vec2& p, uint32_t seed) {
  const float fx = std::floor(p.x);
  const float fy = std::floor(p.y);
  const auto x = static_cast<int>(fx);
  const auto y = static_cast<int>(fy);
  const auto ease = [](float t) { return t * t * (3 - 2 * t); };
  const float s = ease(p.x - fx);
  const float t = ease(p.y - fy);
  const float low = latticeNoise(x, y, seed) * (1 - s) + latticeNoise(x + 1, y, seed) * s;
  const float high = latticeNoise(x, y + 1, seed) * (1 - s) + latticeNoise(x + 1, y + 1, seed) * s;
  return low * (1 - t) + high * t;
}

/// `octaves` of smoothNoise(), each half as wide and half as strong as the one before: in [-1, 1), around 0.
inline float layeredNoise(glm::vec2 p, int octaves, uint32_t seed) {
  float sum = 0;
  float strength = 1;
  float total = 0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += strength * (2 * smoothNoise(p, seed + static_cast<uint32_t>(octave) * 7919u) - 1);
    total += strength;
    strength *= 0.5f;
    p = p * 2.03f + glm::vec2(17.1f, 5.7f);
  }
  return sum / total;
}

/// 0 below `from`, 1 over `to`, smooth between.
inline float smoothEdge(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

}  // namespace ocelli
