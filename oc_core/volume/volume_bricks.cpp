#include "oc_core/volume/volume_bricks.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <span>
#include <type_traits>

#include "oc_core/base/parallel.h"
#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

constexpr int kEdge = VolumeBricks::kEdge;

float roundedDown(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded > value ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float roundedUp(double value) {
  return -roundedDown(-value);
}

/// The least and the greatest value at each i, over some of the rows of a volume. The loops have no dependence between
/// elements, so they become vector instructions.
template <class Voxel>
class RowRange {
 public:
  explicit RowRange(size_t width) : least_(width), greatest_(width) {}

  void clear() { isFirst_ = true; }

  void add(const Voxel* row) {
    const size_t width = least_.size();
    if (isFirst_) {
      std::copy(row, row + width, least_.begin());
      std::copy(row, row + width, greatest_.begin());
      isFirst_ = false;
      return;
    }
    Voxel* least = least_.data();
    Voxel* greatest = greatest_.data();
    for (size_t i = 0; i < width; ++i) {
      const Voxel value = row[i];
      least[i] = value < least[i] ? value : least[i];
      greatest[i] = value > greatest[i] ? value : greatest[i];
    }
  }

  void addZeros() { add(std::vector<Voxel>(least_.size()).data()); }

  double leastOf(size_t begin, size_t end) const {
    return static_cast<double>(
        *std::min_element(least_.begin() + std::ptrdiff_t(begin), least_.begin() + std::ptrdiff_t(end)));
  }
  double greatestOf(size_t begin, size_t end) const {
    return static_cast<double>(
        *std::max_element(greatest_.begin() + std::ptrdiff_t(begin), greatest_.begin() + std::ptrdiff_t(end)));
  }

 private:
  bool isFirst_ = true;
  std::vector<Voxel> least_;
  std::vector<Voxel> greatest_;
};

/// Writes the ranges of the bricks (0, b, c), (1, b, c), ...
template <class Voxel>
void addBrickRow(const ScalarVolume& volume, const Voxel* first, size_t b, size_t c, RowRange<Voxel>& rows,
                 std::span<BrickRange> ranges) {
  const glm::ivec3& size = volume.grid().size;
  const auto width = static_cast<size_t>(size.x);
  const size_t beginJ = b * kEdge;
  const size_t endJ = std::min(beginJ + kEdge + 1, static_cast<size_t>(size.y));
  const size_t endK = std::min((c + 1) * kEdge + 1, static_cast<size_t>(size.z));
  rows.clear();
  for (size_t k = c * kEdge; k < endK; ++k) {
    if (areRowsKnownZero(volume, k, beginJ, endJ)) {
      rows.addZeros();
      continue;
    }
    for (size_t j = beginJ; j < endJ; ++j) {
      rows.add(first + (k * static_cast<size_t>(size.y) + j) * width);
    }
  }
  for (size_t a = 0; a < ranges.size(); ++a) {
    const size_t end = std::min((a + 1) * kEdge + 1, width);
    const double one = volume.scale() * rows.leastOf(a * kEdge, end) + volume.offset();
    const double other = volume.scale() * rows.greatestOf(a * kEdge, end) + volume.offset();
    ranges[a] = {roundedDown(std::min(one, other)), roundedUp(std::max(one, other))};
  }
}

}  // namespace

VolumeBricks::VolumeBricks(const ScalarVolume& volume) : size_(glm::max((volume.grid().size + kEdge - 2) / kEdge, 1)) {
  const auto layers = static_cast<size_t>(size_.z);
  const auto rowsOfLayer = static_cast<size_t>(size_.y);
  ranges_.resize(layers * rowsOfLayer * static_cast<size_t>(size_.x));
  // Of what may not fit into memory, a layer at a time.
  const size_t layersAtOnce = volume.store() != nullptr ? 1 : layers;
  for (size_t layer = 0; layer < layers; layer += layersAtOnce) {
    const RowsInMemory slices(volume, {layer * kEdge, (layer + layersAtOnce) * kEdge + 1});
    visitVoxels(volume, [&](const auto* first) {
      using Voxel = std::remove_cv_t<std::remove_pointer_t<decltype(first)>>;
      parallelFor(layersAtOnce * rowsOfLayer, 1, [&](size_t begin, size_t end) {
        RowRange<Voxel> rows(static_cast<size_t>(volume.grid().size.x));
        for (size_t row = begin; row < end; ++row) {
          const size_t c = layer + row / rowsOfLayer;
          const size_t b = row % rowsOfLayer;
          addBrickRow(volume, first, b, c, rows,
                      std::span(ranges_).subspan(indexOf({0, int(b), int(c)}), static_cast<size_t>(size_.x)));
        }
      });
    });
  }
}

ValueRange rangeOf(const VolumeBricks& bricks) {
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const BrickRange& brick : bricks.ranges()) {
    range.least = std::min(range.least, static_cast<double>(brick.least));
    range.greatest = std::max(range.greatest, static_cast<double>(brick.greatest));
  }
  return range;
}

}  // namespace ocelli
