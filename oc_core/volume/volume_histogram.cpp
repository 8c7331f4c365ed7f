#include "oc_core/volume/volume_histogram.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <type_traits>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/volume/volume_scan.h"
#include "oc_core/volume/voxel_survey.h"

namespace ocelli {
namespace {

constexpr double kMaxWholeNumbers = 65536;
constexpr size_t kBins = 4096;

/// Which bin a voxel is in, as voxels hold values.
struct VoxelBins {
  /// `stored` is the range as voxels hold it.
  VoxelBins(VoxelType type, const ValueRange& stored) : least(stored.least), greatest(stored.greatest) {
    const bool isWhole = type != VoxelType::kFloat32 && type != VoxelType::kFloat64;
    countsEach = isWhole && greatest - least < kMaxWholeNumbers;
    if (countsEach) {
      bins = static_cast<size_t>(greatest - least) + 1;
      least -= 0.5;
      greatest += 0.5;
    } else {
      bins = greatest > least ? kBins : 1;
    }
    binsByValue = greatest > least ? static_cast<double>(bins) / (greatest - least) : 0;
  }

  size_t binOf(double voxel) const {
    return std::min(static_cast<size_t>(std::max((voxel - least) * binsByValue, 0.0)), bins - 1);
  }

  double least;
  double greatest;
  bool countsEach = false;
  size_t bins = 1;
  double binsByValue = 0;
};

template <class Voxel>
void countSlice(const ScalarVolume& volume, const Voxel* first, size_t slice, const VoxelBins& bins,
                std::vector<uint64_t>& counts) {
  const auto width = static_cast<size_t>(volume.grid().size.x);
  visitRows(
      volume, first, slice,
      [&](size_t /*j*/, const Voxel* row) {
        if constexpr (std::is_floating_point_v<Voxel>) {
          for (size_t i = 0; i < width; ++i) {
            if (std::isfinite(row[i])) {
              ++counts[bins.binOf(static_cast<double>(row[i]))];
            }
          }
        } else if (bins.countsEach) {
          const auto least = static_cast<int64_t>(bins.least + 0.5);
          for (size_t i = 0; i < width; ++i) {
            ++counts[static_cast<size_t>(static_cast<int64_t>(row[i]) - least)];
          }
        } else {
          for (size_t i = 0; i < width; ++i) {
            ++counts[bins.binOf(static_cast<double>(row[i]))];
          }
        }
      },
      [&](size_t rows) { counts[bins.binOf(0)] += rows * width; });
}

}  // namespace

uint64_t VolumeHistogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), uint64_t{0});
}

VolumeHistogram histogramOf(const ScalarVolume& volume) {
  const VoxelSurvey survey = surveyVoxels(volume);
  VolumeHistogram histogram{.values = survey.range};
  const VoxelBins bins(volume.type(), survey.stored);
  histogram.counts.resize(bins.bins);
  std::mutex mutex;
  visitVoxels(volume, [&](const auto* first) {
    scanSlices(volume, 0, static_cast<size_t>(volume.grid().size.z), [&](size_t begin, size_t end) {
      std::vector<uint64_t> counts(bins.bins);
      for (size_t slice = begin; slice < end; ++slice) {
        countSlice(volume, first, slice, bins, counts);
      }
      const std::scoped_lock lock(mutex);
      std::ranges::transform(counts, histogram.counts, histogram.counts.begin(), std::plus<>());
    });
  });
  histogram.bounds = {volume.scale() * bins.least + volume.offset(), volume.scale() * bins.greatest + volume.offset()};
  if (volume.scale() < 0) {
    std::swap(histogram.bounds.least, histogram.bounds.greatest);
    std::ranges::reverse(histogram.counts);
  }
  return histogram;
}

}  // namespace ocelli
