#include "oc_core/volume/voxel_survey.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

/// The least and the greatest of some voxels, as voxels hold them.
template <class Voxel>
struct VoxelBounds {
  /// Compilers make vector instructions of this many independent comparisons.
  static constexpr size_t kLanes = 16;

  Voxel least = std::numeric_limits<Voxel>::max();
  Voxel greatest = std::numeric_limits<Voxel>::lowest();

  void add(Voxel value) {
    least = value < least ? value : least;
    greatest = value > greatest ? value : greatest;
  }

  /// Bounds of nothing, whose least exceeds the greatest, add nothing.
  void add(const VoxelBounds& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
  }

  void addAll(const Voxel* voxels, size_t count) {
    std::array<Voxel, kLanes> lower;
    std::array<Voxel, kLanes> upper;
    lower.fill(least);
    upper.fill(greatest);
    const size_t whole = count / kLanes * kLanes;
    for (size_t i = 0; i < whole; i += kLanes) {
      for (size_t lane = 0; lane < kLanes; ++lane) {
        const Voxel value = voxels[i + lane];
        lower[lane] = value < lower[lane] ? value : lower[lane];
        upper[lane] = value > upper[lane] ? value : upper[lane];
      }
    }
    for (size_t lane = 0; lane < kLanes; ++lane) {
      least = std::min(least, lower[lane]);
      greatest = std::max(greatest, upper[lane]);
    }
    for (size_t i = whole; i < count; ++i) {
      add(voxels[i]);
    }
  }
};

template <class Voxel>
size_t countNotFinite(const Voxel* voxels, size_t count) {
  if constexpr (std::is_floating_point_v<Voxel>) {
    size_t bad = 0;
    for (size_t i = 0; i < count; ++i) {
      bad += std::abs(voxels[i]) <= std::numeric_limits<Voxel>::max() ? 0 : 1;
    }
    return bad;
  } else {
    return 0;
  }
}

template <class Voxel>
class SurveyOfSlices {
 public:
  explicit SurveyOfSlices(const ScalarVolume& volume) : volume_(volume) {}

  void addSlice(const Voxel* first, size_t slice) {
    const auto width = static_cast<size_t>(volume_.grid().size.x);
    visitRows(
        volume_, first, slice,
        [&](size_t j, const Voxel* row) {
          const size_t bad = countNotFinite(row, width);
          if (bad == 0) {
            bounds_.addAll(row, width);
          } else {
            addPartly(row, width, slice * static_cast<size_t>(volume_.grid().size.y) + j);
            notFinite_ += bad;
          }
        },
        [&](size_t /*rows*/) { bounds_.add(0); });
  }

  void add(const SurveyOfSlices& other) {
    bounds_.add(other.bounds_);
    notFinite_ += other.notFinite_;
    firstBad_ = std::min(firstBad_, other.firstBad_);
  }

  VoxelSurvey result() const {
    VoxelSurvey survey{.notFinite = notFinite_};
    if (bounds_.least <= bounds_.greatest) {
      survey.stored = {static_cast<double>(bounds_.least), static_cast<double>(bounds_.greatest)};
      const double one = volume_.scale() * survey.stored.least + volume_.offset();
      const double other = volume_.scale() * survey.stored.greatest + volume_.offset();
      survey.range = {std::min(one, other), std::max(one, other)};
    }
    if (notFinite_ > 0) {
      const auto width = static_cast<size_t>(volume_.grid().size.x);
      const auto height = static_cast<size_t>(volume_.grid().size.y);
      survey.firstNotFinite = {static_cast<int>(firstBad_ % width), static_cast<int>(firstBad_ / width % height),
                               static_cast<int>(firstBad_ / width / height)};
    }
    return survey;
  }

 private:
  void addPartly(const Voxel* row, size_t width, size_t rowIndex) {
    for (size_t i = 0; i < width; ++i) {
      if (countNotFinite(row + i, 1) == 0) {
        bounds_.add(row[i]);
      } else {
        firstBad_ = std::min(firstBad_, rowIndex * width + i);
      }
    }
  }

  const ScalarVolume& volume_;
  VoxelBounds<Voxel> bounds_;
  size_t notFinite_ = 0;
  size_t firstBad_ = std::numeric_limits<size_t>::max();
};

}  // namespace

VoxelSurvey surveyVoxels(const ScalarVolume& volume) {
  return visitVoxels(volume, [&](const auto* first) {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    SurveyOfSlices<Voxel> all(volume);
    std::mutex mutex;
    scanSlices(volume, 0, static_cast<size_t>(volume.grid().size.z), [&](size_t begin, size_t end) {
      SurveyOfSlices<Voxel> part(volume);
      for (size_t slice = begin; slice < end; ++slice) {
        part.addSlice(first, slice);
      }
      const std::scoped_lock lock(mutex);
      all.add(part);
    });
    return all.result();
  });
}

void requireFinite(const VoxelSurvey& survey, const std::string& where, int factor) {
  if (survey.notFinite == 0) {
    return;
  }
  const glm::ivec3 at = survey.firstNotFinite * factor;
  const std::string first = factor == 1
                                ? fmt::format("at index ({}, {}, {})", at.x, at.y, at.z)
                                : fmt::format("among those from index ({}, {}, {}) up to {} further along each axis",
                                              at.x, at.y, at.z, factor - 1);
  throw InputError(
      fmt::format("{}{} {} not a finite number (NaN or infinite), the first {}", factor == 1 ? "" : "at least ",
                  survey.notFinite, survey.notFinite == 1 ? "voxel is" : "voxels are", first),
      where, "give these voxels a value, such as that of the background");
}

ValueRange valueRange(const ScalarVolume& volume) {
  return surveyVoxels(volume).range;
}

}  // namespace ocelli
