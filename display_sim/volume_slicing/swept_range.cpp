#include "display_sim/volume_slicing/swept_range.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

constexpr size_t kMaxRangeVoxels = size_t{1} << 19;
/// Fewer tell nothing of one in a hundred.
constexpr size_t kMinRangeVoxels = 256;
constexpr double kRareShare = 0.005;
constexpr double kCommonMargin = 0.5;  ///< of the common values' width
constexpr double kWantedMargin = 0.03;

/// Every n-th voxel of all that are finite.
std::vector<double> sampledValues(const ScalarVolume& volume) {
  const glm::ivec3& size = volume.grid().size;
  const size_t layer = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
  // An odd distance meets all columns and rows of grids with sides that are powers of two.
  const size_t stride = volume.grid().voxelCount() / kMaxRangeVoxels | 1;
  std::vector<double> values;
  visitVoxels(volume, [&](const auto* first) {
    for (size_t k = 0; k < static_cast<size_t>(size.z); ++k) {
      const RowsInMemory slice(volume, {k, k + 1}, kAllRows, stride < 64);
      for (size_t i = (k * layer + stride - 1) / stride * stride; i < (k + 1) * layer; i += stride) {
        const double value = volume.scale() * static_cast<double>(first[i]) + volume.offset();
        if (std::isfinite(value)) {
          values.push_back(value);
        }
      }
    }
  });
  return values;
}

double rankedValue(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

bool looksTheSame(const TransferPoint& a, const TransferPoint& b) {
  return a.opacity == b.opacity && (a.opacity == 0 || a.color == b.color);
}

}  // namespace

ValueRange commonValues(const ScalarVolume& volume) {
  std::vector<double> values = sampledValues(volume);
  if (values.empty()) {
    return valueRange(volume);
  }
  const double median = rankedValue(values, 0.5);
  std::erase(values, median);
  if (values.size() < kMinRangeVoxels) {
    return valueRange(volume);
  }
  const double least = rankedValue(values, kRareShare);
  return {std::min(least, median), std::max(rankedValue(values, 1 - kRareShare), median)};
}

std::vector<double> valuesOfChange(const TransferFunction& transfer) {
  const std::vector<TransferPoint>& points = transfer.points();
  size_t first = 0;
  size_t last = points.size() - 1;
  while (first < last && looksTheSame(points[first], points[first + 1])) {
    ++first;
  }
  while (last > first && looksTheSame(points[last], points[last - 1])) {
    --last;
  }
  if (first == last) {
    return {};
  }
  return {points[first].value, points[last].value};
}

ValueRange codedRange(const ValueRange& all, const ValueRange& common, const std::vector<double>& wanted) {
  const double beside = kCommonMargin * (common.greatest - common.least);
  ValueRange range{common.least - beside, common.greatest + beside};
  ValueRange joined = common;
  for (const double value : wanted) {
    const double inside = std::clamp(value, all.least, all.greatest);
    joined = {std::min(joined.least, inside), std::max(joined.greatest, inside)};
  }
  const double margin = kWantedMargin * (joined.greatest - joined.least);
  for (const double value : wanted) {
    const double inside = std::clamp(value, all.least, all.greatest);
    range = {std::min(range.least, inside - margin), std::max(range.greatest, inside + margin)};
  }
  return {std::max(range.least, all.least), std::min(range.greatest, all.greatest)};
}

}  // namespace ocelli
