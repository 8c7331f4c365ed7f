// Noise: clouds of any size of detail, the same for each seed.
//
//   K. Perlin, "Improving noise", 2002: the interpolation and the gradients. The lattice is hashed instead of permuted,
//   so that it does not repeat.
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>

#include "oc_core/volume/builtin_volume_list.h"
#include "oc_core/volume/made_volume.h"

namespace ocelli {
namespace {

constexpr int kOctaves = 5;
constexpr float kCoarsestCells = 4;  ///< along an edge

uint32_t latticeHash(int x, int y, int z, uint32_t seed) {
  uint32_t hash = seed + uint32_t(x) * 0x8da6b343u + uint32_t(y) * 0xd8163841u + uint32_t(z) * 0xcb1ab31fu;
  hash = (hash ^ (hash >> 15U)) * 0x2c1b3c6du;
  hash = (hash ^ (hash >> 12U)) * 0x297a2d39u;
  return hash ^ (hash >> 15U);
}

/// The dot product with one of the 12 gradients towards the edges of a cube (of 16, four twice).
float latticeGradient(uint32_t hash, const glm::vec3& p) {
  const uint32_t h = hash & 15U;
  const float u = h < 8 ? p.x : p.y;
  const float v = h < 4 ? p.y : (h == 12 || h == 14 ? p.x : p.z);
  return ((h & 1U) != 0 ? -u : u) + ((h & 2U) != 0 ? -v : v);
}

/// Between -1 and 1, about.
float perlinNoise(const glm::vec3& p, uint32_t seed) {
  const glm::vec3 lower = glm::floor(p);
  const glm::vec3 t = p - lower;
  const glm::ivec3 cell(lower);
  const glm::vec3 s = t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
  const auto corner = [&](int x, int y, int z) {
    return latticeGradient(latticeHash(cell.x + x, cell.y + y, cell.z + z, seed), t - glm::vec3(x, y, z));
  };
  const auto edge = [&](int y, int z) { return glm::mix(corner(0, y, z), corner(1, y, z), s.x); };
  return glm::mix(glm::mix(edge(0, 0), edge(1, 0), s.y), glm::mix(edge(0, 1), edge(1, 1), s.y), s.z);
}

BuiltinVolume makeNoise(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  const auto seed = static_cast<uint32_t>(values.count("seed"));
  ScalarVolume volume =
      madeVolume<float>(gridAroundOrigin(glm::ivec3(count), 2.0 / count), [&](int j, int k, std::span<float> row) {
        for (size_t i = 0; i < row.size(); ++i) {
          const glm::vec3 p = kCoarsestCells * glm::vec3(float(i), float(j), float(k)) / static_cast<float>(count);
          float sum = 0;
          float frequency = 1;
          for (int octave = 0; octave < kOctaves; ++octave) {
            sum += perlinNoise(p * frequency, seed + uint32_t(octave)) / frequency;
            frequency *= 2;
          }
          row[i] = std::clamp(0.5f + 0.5f * sum, 0.0f, 1.0f);
        }
      });
  return {std::move(volume),
          {TransferFunction(
               {transferPoint(0.5, 0x3b496c, 0), transferPoint(0.6, 0x8a8678, 0.05), transferPoint(0.8, 0xfee838, 0.3)},
               2.0 / 64),
           {.isOn = true}}};
}

}  // namespace

BuiltinVolumeKind noiseVolume() {
  return {"noise",
          "clouds of Perlin's noise in five octaves, 0 to 1",
          {sizeParameter(128),
           {.name = "seed",
            .summary = "another one makes other clouds",
            .kind = BuiltinParameter::Kind::kInteger,
            .otherwise = "1",
            .least = 0,
            .most = 1e9}},
          makeNoise};
}

}  // namespace ocelli
