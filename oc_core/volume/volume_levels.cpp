#include "oc_core/volume/volume_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

constexpr const char* kLevelStage = "making a coarser volume";

glm::ivec3 levelSize(const glm::ivec3& size, const glm::ivec3& factor) {
  return (size - 1) / factor + 1;
}

/// Of voxels that mean scale n + offset for the number n. With the facts of the whole.
template <class Voxel>
ScalarVolume levelOf(const ScalarVolume& whole, const glm::ivec3& factor, VoxelType type, std::vector<Voxel> voxels,
                     double scale, double offset) {
  const auto owned = std::make_shared<const std::vector<Voxel>>(std::move(voxels));
  ScalarVolume level(levelGrid(whole.grid(), factor), type, std::as_bytes(std::span(*owned)), owned, scale, offset);
  level.setFacts(whole.facts());
  return level;
}

/// A volume like the whole, of these voxels.
template <class Voxel>
ScalarVolume levelLike(const ScalarVolume& whole, int factor, std::vector<Voxel> voxels) {
  return levelOf(whole, glm::ivec3(factor), whole.type(), std::move(voxels), whole.scale(), whole.offset());
}

/// Sums over the rows that one row of a level stands for, of what `numberOf` says of each voxel.
template <class Voxel, class NumberOf>
class RowSums {
 public:
  RowSums(size_t width, size_t levelWidth, size_t factor, const NumberOf& numberOf)
      : width_(width), factor_(factor), sums_(levelWidth), numberOf_(numberOf) {}

  void clear() {
    std::ranges::fill(sums_, 0.0);
    rows_ = 0;
    zeroRows_ = 0;
  }

  void add(const Voxel* row) {
    for (size_t a = 0; a < sums_.size(); ++a) {
      const size_t end = std::min((a + 1) * factor_, width_);
      double sum = 0;
      for (size_t i = a * factor_; i < end; ++i) {
        sum += numberOf_(row[i]);
      }
      sums_[a] += sum;
    }
    ++rows_;
  }

  void addZeros(size_t rows) { zeroRows_ += rows; }

  double meanAt(size_t a) const {
    const auto columns = static_cast<double>(std::min((a + 1) * factor_, width_) - a * factor_);
    const double zeros = static_cast<double>(zeroRows_) * columns * numberOf_(Voxel{0});
    return (sums_[a] + zeros) / (static_cast<double>(rows_ + zeroRows_) * columns);
  }

 private:
  size_t width_;
  size_t factor_;
  std::vector<double> sums_;
  const NumberOf& numberOf_;
  size_t rows_ = 0;
  size_t zeroRows_ = 0;
};

/// What is read at once of a volume that may not fit into memory.
constexpr size_t kLevelBytesAtOnce = size_t{128} << 20U;

/// Rows of a level that are made at once, of those of its slice, where they stand for `slices` of a whole.
size_t levelRowsAtOnce(const ScalarVolume& whole, size_t slices, int factor, size_t height) {
  const size_t rowBytes = static_cast<size_t>(whole.grid().size.x) * bytesOf(whole.type());
  return std::clamp<size_t>(kLevelBytesAtOnce / (slices * static_cast<size_t>(factor) * rowBytes), 1, height);
}

/// The voxels of a level. Calls `row((first, last), the voxels of the level's row)` for its rows, on all threads. While
/// rows of slice c of the level are made, those of the slices `slicesOf(c)` of the whole that they stand for may be
/// read; all of them are, where `readsAll`.
template <class Voxel, class SlicesOf, class MakeRow>
std::vector<Voxel> makeLevel(const ScalarVolume& whole, const glm::ivec3& factor, bool readsAll,
                             const Progress& progress, const SlicesOf& slicesOf, const MakeRow& makeRow) {
  const glm::ivec3 size = levelSize(whole.grid().size, factor);
  const auto width = static_cast<size_t>(size.x);
  const auto height = static_cast<size_t>(size.y);
  const auto depth = static_cast<size_t>(size.z);
  std::vector<Voxel> voxels(width * height * depth);
  const auto makeRows = [&](size_t first, size_t last) {
    report(progress, kLevelStage, static_cast<double>(first) / static_cast<double>(depth * height));
    parallelFor(last - first, std::min<size_t>(16, last - first), [&](size_t from, size_t to) {
      makeRow(std::pair(first + from, first + to),
              [&](size_t row) { return std::span(voxels).subspan(row * width, width); });
    });
  };
  if (whole.store() == nullptr) {
    makeRows(0, depth * height);
  }
  for (size_t c = 0; c < depth && whole.store() != nullptr; ++c) {
    const auto [firstSlice, lastSlice] = slicesOf(c);
    const size_t atOnce = levelRowsAtOnce(whole, lastSlice - firstSlice, factor.y, height);
    for (size_t b = 0; b < height; b += atOnce) {
      const size_t end = std::min(b + atOnce, height);
      const auto step = static_cast<size_t>(factor.y);
      const RowsInMemory rows(whole, {firstSlice, lastSlice}, {b * step, end * step}, readsAll);
      makeRows(c * height + b, c * height + end);
    }
  }
  return voxels;
}

/// Means of what `numberOf` says of the voxels that each stands for, as `voxelOf(mean)` keeps them. `first` is the
/// first voxel of the whole.
template <class Out, class Voxel, class NumberOf, class VoxelOf>
std::vector<Out> averagedVoxels(const ScalarVolume& whole, const Voxel* first, const glm::ivec3& factor,
                                const Progress& progress, const NumberOf& numberOf, const VoxelOf& voxelOf) {
  OC_CHECK(factor.x >= 1 && factor.y >= 1 && factor.z >= 1, "a level is not finer than the whole");
  const auto width = static_cast<size_t>(whole.grid().size.x);
  const auto height = static_cast<size_t>(whole.grid().size.y);
  const auto depth = static_cast<size_t>(whole.grid().size.z);
  const auto stepX = static_cast<size_t>(factor.x);
  const auto stepY = static_cast<size_t>(factor.y);
  const auto stepZ = static_cast<size_t>(factor.z);
  const size_t levelHeight = (height - 1) / stepY + 1;
  return makeLevel<Out>(
      whole, factor, true, progress, [&](size_t c) { return std::pair(c * stepZ, std::min((c + 1) * stepZ, depth)); },
      [&](std::pair<size_t, size_t> rows, const auto& rowOf) {
        RowSums<Voxel, NumberOf> sums(width, (width - 1) / stepX + 1, stepX, numberOf);
        for (size_t row = rows.first; row < rows.second; ++row) {
          const size_t beginJ = row % levelHeight * stepY;
          const size_t endJ = std::min(beginJ + stepY, height);
          const size_t beginK = row / levelHeight * stepZ;
          sums.clear();
          for (size_t k = beginK; k < std::min(beginK + stepZ, depth); ++k) {
            if (areRowsKnownZero(whole, k, beginJ, endJ)) {
              sums.addZeros(endJ - beginJ);
              continue;
            }
            for (size_t j = beginJ; j < endJ; ++j) {
              sums.add(first + (k * height + j) * width);
            }
          }
          const std::span<Out> level = rowOf(row);
          for (size_t a = 0; a < level.size(); ++a) {
            level[a] = voxelOf(sums.meanAt(a));
          }
        }
      });
}

}  // namespace

int levelFactor(const glm::ivec3& size, size_t maxVoxels) {
  OC_CHECK(maxVoxels > 0, "a level has voxels");
  const auto voxels = [&](int factor) {
    const glm::ivec3 level = levelSize(size, glm::ivec3(factor));
    return size_t(level.x) * size_t(level.y) * size_t(level.z);
  };
  int factor = 1;
  while (voxels(factor) > maxVoxels) {
    ++factor;
  }
  return factor;
}

glm::dmat4 wholeFromLevelIndex(const glm::ivec3& factor) {
  // Voxel i of the level stands for those from factor i to factor (i + 1) - 1.
  glm::dmat4 matrix(1);
  for (int axis = 0; axis < 3; ++axis) {
    matrix[axis][axis] = factor[axis];
    matrix[3][axis] = (factor[axis] - 1) / 2.0;
  }
  return matrix;
}

VolumeGrid levelGrid(const VolumeGrid& whole, const glm::ivec3& factor) {
  VolumeGrid grid = whole;
  grid.size = levelSize(whole.size, factor);
  grid.worldFromIndex = whole.worldFromIndex * wholeFromLevelIndex(factor);
  return grid;
}

ScalarVolume averagedLevel(const ScalarVolume& whole, int factor, const Progress& progress) {
  return visitVoxels(whole, [&](const auto* first) {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    return levelLike(whole, factor,
                     averagedVoxels<Voxel>(
                         whole, first, glm::ivec3(factor), progress, [](Voxel v) { return static_cast<double>(v); },
                         [](double mean) {
                           if constexpr (std::is_floating_point_v<Voxel>) {
                             return static_cast<Voxel>(mean);
                           } else {
                             return static_cast<Voxel>(std::llround(mean));
                           }
                         }));
  });
}

ScalarVolume averagedInRange(const ScalarVolume& whole, const glm::ivec3& factor, const ValueRange& range,
                             const Progress& progress) {
  constexpr double kSteps = 65535;
  const double extent = range.greatest - range.least;
  const double stepsByValue = extent > 0 ? kSteps / extent : 0;
  // What a voxel holds at the ends of the range.
  const double atLeast = whole.scale() != 0 ? (range.least - whole.offset()) / whole.scale() : 0;
  const double atGreatest = whole.scale() != 0 ? (range.greatest - whole.offset()) / whole.scale() : 0;
  const double lower = std::min(atLeast, atGreatest);
  const double upper = std::max(atLeast, atGreatest);
  const auto voxelOf = [&](double mean) {
    const double value = whole.scale() * mean + whole.offset();
    return static_cast<uint16_t>(std::clamp((value - range.least) * stepsByValue, 0.0, kSteps) + 0.5);
  };
  return visitVoxels(whole, [&]<class Voxel>(const Voxel* first) {
    return levelOf(whole, factor, VoxelType::kUint16,
                   averagedVoxels<uint16_t>(
                       whole, first, factor, progress,
                       [&](Voxel v) { return std::clamp(static_cast<double>(v), lower, upper); }, voxelOf),
                   extent > 0 ? extent / kSteps : 1, range.least);
  });
}

ScalarVolume sampledLevel(const ScalarVolume& whole, int factor, const Progress& progress) {
  OC_CHECK(factor >= 1, "a level is not finer than the whole");
  const auto step = static_cast<size_t>(factor);
  const auto width = static_cast<size_t>(whole.grid().size.x);
  const auto height = static_cast<size_t>(whole.grid().size.y);
  const auto depth = static_cast<size_t>(whole.grid().size.z);
  const size_t levelHeight = (height - 1) / step + 1;
  const auto middle = [&](size_t index, size_t count) { return std::min(index * step + (step - 1) / 2, count - 1); };
  return visitVoxels(whole, [&](const auto* first) {
    using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
    return levelLike(whole, factor,
                     makeLevel<Voxel>(
                         whole, glm::ivec3(factor), false, progress,
                         [&](size_t c) { return std::pair(middle(c, depth), middle(c, depth) + 1); },
                         [&](std::pair<size_t, size_t> rows, const auto& rowOf) {
                           const auto sliceOf = [&](size_t row) { return middle(row / levelHeight, depth); };
                           const auto lineOf = [&](size_t row) { return middle(row % levelHeight, height); };
                           for (size_t row = rows.first; row < rows.second && whole.store() != nullptr; ++row) {
                             const size_t begin = (sliceOf(row) * height + lineOf(row)) * width * sizeof(Voxel);
                             if (!areRowsKnownZero(whole, sliceOf(row), lineOf(row), lineOf(row) + 1)) {
                               whole.store()->willRead(begin, begin + width * sizeof(Voxel));
                             }
                           }
                           for (size_t row = rows.first; row < rows.second; ++row) {
                             const size_t k = sliceOf(row);
                             const size_t j = lineOf(row);
                             if (areRowsKnownZero(whole, k, j, j + 1)) {
                               continue;
                             }
                             const Voxel* from = first + (k * height + j) * width;
                             const std::span<Voxel> to = rowOf(row);
                             for (size_t a = 0; a < to.size(); ++a) {
                               to[a] = from[middle(a, width)];
                             }
                           }
                         }));
  });
}

VolumeLevel levelFor(std::shared_ptr<const ScalarVolume> whole, const LevelOptions& options, const Progress& progress) {
  if (whole->voxels().size() <= options.maxWholeBytes) {
    return {std::move(whole)};
  }
  const size_t toRead = whole->store() == nullptr ? whole->voxels().size() : whole->store()->bytesToRead();
  const bool isSampled = toRead > options.maxBytesToRead;
  const size_t maxBytes = isSampled ? options.maxSampledBytes : options.maxBytes;
  const int factor = levelFactor(whole->grid().size, std::max<size_t>(maxBytes / bytesOf(whole->type()), 1));
  return {std::make_shared<const ScalarVolume>(isSampled ? sampledLevel(*whole, factor, progress)
                                                         : averagedLevel(*whole, factor, progress)),
          factor, isSampled};
}

std::string describeLevel(const VolumeLevel& level, const VolumeGrid& whole) {
  if (level.factor == 1) {
    return "";
  }
  const glm::ivec3& to = level.volume->grid().size;
  return fmt::format("a volume of {} x {} x {} voxels is shown by {} x {} x {}, each {} {} x {} x {} of them",
                     whole.size.x, whole.size.y, whole.size.z, to.x, to.y, to.z,
                     level.isSampled ? "one of" : "the mean of", level.factor, level.factor, level.factor);
}

}  // namespace ocelli
