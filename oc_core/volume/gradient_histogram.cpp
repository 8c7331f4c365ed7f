#include "oc_core/volume/gradient_histogram.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <mutex>

#include "oc_core/base/check.h"
#include "oc_core/volume/volume_gradient.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

struct ValueAndGradient {
  float value = 0;
  float gradient = 0;
};

/// Every how-manieth voxel along each axis.
int strideFor(const glm::ivec3& size) {
  int stride = 1;
  const auto samples = [&] {
    const auto along = [&](int count) { return size_t(count + stride - 1) / size_t(stride); };
    return along(size.x) * along(size.y) * along(size.z);
  };
  while (samples() > kMaxGradientVoxels) {
    ++stride;
  }
  return stride;
}

/// As gradientAt(), at a voxel.
double gradientLength(const ScalarVolume& volume, const glm::dmat3& worldFromIndex, const glm::ivec3& voxel) {
  glm::dvec3 byIndex(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 before = voxel;
    glm::ivec3 after = voxel;
    before[axis] = std::max(voxel[axis] - 1, 0);
    after[axis] = std::min(voxel[axis] + 1, volume.grid().size[axis] - 1);
    if (after[axis] > before[axis]) {
      byIndex[axis] = (volume.valueAt(after) - volume.valueAt(before)) / (after[axis] - before[axis]);
    }
  }
  return glm::length(worldFromIndex * byIndex);
}

}  // namespace

GradientHistogram gradientHistogramOf(const ScalarVolume& volume, size_t columns, size_t rows) {
  OC_CHECK(columns > 0 && rows > 0, "a histogram has bins");
  const glm::ivec3& size = volume.grid().size;
  const int stride = strideFor(size);
  const glm::dmat3 worldFromIndex = worldGradientFromIndex(volume.grid().worldFromIndex);
  const auto width = static_cast<size_t>((size.x + stride - 1) / stride);
  const auto height = static_cast<size_t>((size.y + stride - 1) / stride);
  const auto depth = static_cast<size_t>((size.z + stride - 1) / stride);
  std::vector<ValueAndGradient> samples(width * height * depth);
  scanSlices(volume, 0, static_cast<size_t>(size.z), [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      if (k % static_cast<size_t>(stride) != 0) {
        continue;
      }
      size_t at = k / static_cast<size_t>(stride) * width * height;
      for (int j = 0; j < size.y; j += stride) {
        for (int i = 0; i < size.x; i += stride) {
          const glm::ivec3 voxel(i, j, static_cast<int>(k));
          samples[at++] = {static_cast<float>(volume.valueAt(voxel)),
                           static_cast<float>(gradientLength(volume, worldFromIndex, voxel))};
        }
      }
    }
  });
  const auto [least, greatest] = std::ranges::minmax_element(samples, {}, &ValueAndGradient::value);
  GradientHistogram histogram{
      .values = {least->value, greatest->value},
      .maxGradient = std::ranges::max_element(samples, {}, &ValueAndGradient::gradient)->gradient,
      .columns = columns,
      .rows = rows,
      .counts = std::vector<uint64_t>(columns * rows)};
  const auto binOf = [](double share, size_t bins) {
    return std::min(static_cast<size_t>(share * static_cast<double>(bins)), bins - 1);
  };
  const double range = histogram.values.greatest - histogram.values.least;
  for (const ValueAndGradient& sample : samples) {
    const size_t column = range > 0 ? binOf((sample.value - histogram.values.least) / range, columns) : 0;
    const size_t row = histogram.maxGradient > 0 ? binOf(sample.gradient / histogram.maxGradient, rows) : 0;
    ++histogram.counts[row * columns + column];
  }
  return histogram;
}

}  // namespace ocelli
