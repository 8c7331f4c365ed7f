// Volumes that are a formula: what analytic tests and comparisons of renderers take.
#include <array>
#include <cmath>
#include <numbers>

#include "oc_core/volume/builtin_volume_list.h"
#include "oc_core/volume/made_volume.h"

namespace ocelli {
namespace {

/// S. Marschner and R. Lobb, "An evaluation of reconstruction filters for volume rendering", 1994: the test signal
/// between -1 and 1, with alpha = 0.25 and a frequency of 6. It is one part by (x, y) and one by z.
BuiltinVolume makeMarschnerLobb(const BuiltinValues& values) {
  constexpr double kAlpha = 0.25;
  constexpr double kFrequency = 6;
  const auto count = static_cast<int>(values.count("size"));
  // The outermost centres lie at -1 and 1.
  const double spacing = 2.0 / (count - 1);
  const auto along = [&](int index) { return -1 + spacing * index; };
  std::vector<double> byDepth(values.count("size"));
  for (int k = 0; k < count; ++k) {
    byDepth[static_cast<size_t>(k)] = 1 - std::sin(std::numbers::pi * along(k) / 2);
  }
  const auto waveAt = [&](int i, int j) {
    const double r = std::hypot(along(i), along(j));
    return kAlpha * (1 + std::cos(2 * std::numbers::pi * kFrequency * std::cos(std::numbers::pi * r / 2)));
  };
  std::vector<double> byPlane(values.count("size") * values.count("size"));
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      byPlane[static_cast<size_t>(j) * values.count("size") + static_cast<size_t>(i)] = waveAt(i, j);
    }
  }
  ScalarVolume volume =
      madeVolume<float>(gridAroundOrigin(glm::ivec3(count), spacing), [&](int j, int k, std::span<float> row) {
        const double* plane = &byPlane[static_cast<size_t>(j) * row.size()];
        const double depth = byDepth[static_cast<size_t>(k)];
        for (size_t i = 0; i < row.size(); ++i) {
          row[i] = static_cast<float>((depth + plane[i]) / (2 * (1 + kAlpha)));
        }
      });
  TransferFunction transfer({{0.45, {0.9, 0.6, 0.2}, 0}, {0.5, {0.9, 0.6, 0.2}, 0.9}, {1, {0.9, 0.8, 0.7}, 0.9}}, 0.1);
  return {std::move(volume), {std::move(transfer), {.isOn = true}}};
}

/// 1 within 0.75 of the origin and 0 outside, linear over one voxel.
BuiltinVolume makeSphere(const BuiltinValues& values) {
  constexpr double kRadius = 0.75;
  const auto count = static_cast<int>(values.count("size"));
  const double spacing = 2.0 / count;
  const VolumeGrid grid = gridAroundOrigin(glm::ivec3(count), spacing);
  ScalarVolume volume = madeVolume<float>(grid, [&](int j, int k, std::span<float> row) {
    for (size_t i = 0; i < row.size(); ++i) {
      const auto p = glm::dvec3(grid.worldFromIndex * glm::dvec4(double(i), j, k, 1));
      row[i] = static_cast<float>(std::clamp(0.5 + (kRadius - glm::length(p)) / spacing, 0.0, 1.0));
    }
  });
  return {std::move(volume), {TransferFunction({transferPoint(0, 0xffffff, 0), transferPoint(1, 0xffffff, 0.5)}, 0.5)}};
}

/// 1 everywhere: what is seen of it is its thickness.
BuiltinVolume makeSlab(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  const VolumeGrid grid = gridAroundOrigin({count, count, std::max(count / 4, 1)}, 2.0 / count);
  ScalarVolume volume =
      madeVolume<float>(grid, [](int /*j*/, int /*k*/, std::span<float> row) { std::ranges::fill(row, 1.0f); });
  return {std::move(volume), {TransferFunction({transferPoint(1, 0xffffff, 0.5)}, 0.5)}};
}

/// From 0 at the left face of its box to 1 at the right one, linear between the outermost centres.
BuiltinVolume makeRamp(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  ScalarVolume volume = madeVolume<float>(gridAroundOrigin(glm::ivec3(count), 2.0 / count),
                                          [](int /*j*/, int /*k*/, std::span<float> row) {
                                            for (size_t i = 0; i < row.size(); ++i) {
                                              row[i] = (static_cast<float>(i) + 0.5f) / static_cast<float>(row.size());
                                            }
                                          });
  return {std::move(volume), {TransferFunction({transferPoint(0, 0x00224e, 0), transferPoint(1, 0xfee838, 0.5)}, 0.5)}};
}

BuiltinVolumeKind fieldKind(std::string name, std::string summary, BuiltinVolume (*make)(const BuiltinValues&)) {
  return {std::move(name), std::move(summary), {sizeParameter(64)}, make};
}

}  // namespace

BuiltinVolumeKind marschnerLobbVolume() {
  return fieldKind("marschner-lobb", "the test signal of Marschner and Lobb: rings that reconstruction wears away",
                   makeMarschnerLobb);
}

BuiltinVolumeKind sphereVolume() {
  return fieldKind("sphere", "1 in a sphere and 0 around it", makeSphere);
}

BuiltinVolumeKind slabVolume() {
  return fieldKind("slab", "1 everywhere, a quarter as deep as wide: along its depth it keeps half of the light",
                   makeSlab);
}

BuiltinVolumeKind rampVolume() {
  return fieldKind("ramp", "from 0 at its left face to 1 at its right one", makeRamp);
}

}  // namespace ocelli
