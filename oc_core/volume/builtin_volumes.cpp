#include "oc_core/volume/builtin_volumes.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr std::string_view kPrefix = "builtin:volume";

/// S. Marschner and R. Lobb, "An evaluation of reconstruction filters for volume rendering", 1994: the test signal.
double marschnerLobb(const glm::dvec3& p) {
  constexpr double kAlpha = 0.25;
  constexpr double kFrequency = 6;
  const double r = std::hypot(p.x, p.y);
  const double wave = std::cos(2 * std::numbers::pi * kFrequency * std::cos(std::numbers::pi * r / 2));
  return (1 - std::sin(std::numbers::pi * p.z / 2) + kAlpha * (1 + wave)) / (2 * (1 + kAlpha));
}

}  // namespace

bool isBuiltinVolume(const std::string& source) {
  return source.starts_with(kPrefix);
}

BuiltinVolume makeBuiltinVolume(const std::string& source) {
  if (source != std::string(kPrefix) + ",name=marschner-lobb") {
    throw InputError("there is no such volume", source, "use builtin:volume,name=marschner-lobb");
  }
  constexpr int kSize = 64;
  VolumeGrid grid;
  grid.size = glm::ivec3(kSize);
  const double step = 2.0 / (kSize - 1);
  grid.worldFromIndex = glm::dmat4(glm::dvec4(step, 0, 0, 0), glm::dvec4(0, step, 0, 0), glm::dvec4(0, 0, step, 0),
                                   glm::dvec4(-1, -1, -1, 1));
  std::vector<float> values;
  values.reserve(grid.voxelCount());
  for (int k = 0; k < kSize; ++k) {
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        values.push_back(static_cast<float>(marschnerLobb(glm::dvec3(grid.worldFromIndex * glm::dvec4(i, j, k, 1)))));
      }
    }
  }
  TransferFunction transfer({{0.45, {0.9, 0.6, 0.2}, 0}, {0.5, {0.9, 0.6, 0.2}, 0.9}, {1, {0.9, 0.8, 0.7}, 0.9}}, 0.1);
  return {ScalarVolume(std::move(grid), std::move(values)), {std::move(transfer), {.isOn = true}}};
}

}  // namespace ocelli
