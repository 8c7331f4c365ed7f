#include "display_sim/volume_solidity/masked_volume.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_scan.h"

namespace ocelli {
namespace {

/// How far below all others the value of what is hidden lies, in widths of the range that matters. The field passes
/// through that range within a sixteenth of a voxel then: what it meets there has a sixteenth of its opacity.
constexpr double kHiddenWidths = 16;

TransferPoint pointAt(const TransferFunction& transfer, double value) {
  const OpticalSample sample = transfer.at(value);
  return {value, sample.color, -std::expm1(-sample.extinction * transfer.opacityLength())};
}

/// As it is just below a value.
TransferPoint pointBelow(const TransferFunction& transfer, double value) {
  const auto same = std::ranges::lower_bound(transfer.points(), value, {}, &TransferPoint::value);
  return same != transfer.points().end() && same->value == value ? *same : pointAt(transfer, value);
}

TransferPoint withoutOpacity(TransferPoint point) {
  point.opacity = 0;
  return point;
}

}  // namespace

VolumeMask::VolumeMask(const VolumeScene& scene)
    : volume_(*scene.volume), indexFromScene_(glm::inverse(scene.worldFromIndex)) {}

bool VolumeMask::shows(const glm::dvec3& point) const {
  constexpr double kSet = 0.5;
  const glm::dvec3 nearest = glm::round(glm::dvec3(indexFromScene_ * glm::dvec4(point, 1)));
  for (int axis = 0; axis < 3; ++axis) {
    if (!(nearest[axis] >= 0 && nearest[axis] < volume_.grid().size[axis])) {
      return false;
    }
  }
  return volume_.valueAt(glm::ivec3(nearest)) >= kSet;
}

VolumeScene placedMask(VolumeScene mask, const VolumeScene& scene) {
  const VolumeGrid& grid = scene.volume->grid();
  const glm::dmat4 ownFromIndex = grid.isAnatomical ? sceneFromPatient() * grid.worldFromIndex : grid.worldFromIndex;
  mask.worldFromIndex = scene.worldFromIndex * glm::inverse(ownFromIndex) * mask.worldFromIndex;
  return mask;
}

TransferFunction transferWithin(const TransferFunction& transfer, const ValueRange& shown) {
  std::vector<TransferPoint> points;
  if (std::isfinite(shown.least)) {
    const TransferPoint first = pointAt(transfer, shown.least);
    points = {withoutOpacity(first), first};
  }
  for (const TransferPoint& point : transfer.points()) {
    if (point.value > shown.least && point.value < shown.greatest) {
      points.push_back(point);
    }
  }
  if (std::isfinite(shown.greatest)) {
    const TransferPoint last = pointBelow(transfer, shown.greatest);
    points.insert(points.end(), {last, withoutOpacity(last)});
  }
  return {std::move(points), transfer.opacityLength()};
}

VolumeScene maskedScene(const VolumeScene& scene, const VolumeScene* mask, const std::optional<ValueRange>& shown,
                        const ValueRange& told) {
  VolumeScene masked = scene;
  TransferFunction& transfer = masked.appearance.transfer;
  if (shown) {
    transfer = transferWithin(transfer, *shown);
  }
  if (mask == nullptr) {
    return masked;
  }
  const double width = told.greatest > told.least ? told.greatest - told.least : 1;
  const double least = valueRange(*scene.volume).least;
  const auto hidden = static_cast<float>(least - kHiddenWidths * width);
  const TransferPoint& first = transfer.points().front();
  if (!(first.opacity == 0 && first.value >= static_cast<double>(hidden))) {
    transfer = transferWithin(transfer, {least - 1e-3 * width, std::numeric_limits<double>::infinity()});
  }
  const glm::ivec3& size = scene.volume->grid().size;
  const VolumeMask shows(*mask);
  std::vector<float> values(scene.volume->grid().voxelCount(), hidden);
  scanSlices(*scene.volume, 0, static_cast<size_t>(size.z), [&](size_t begin, size_t end) {
    size_t at = begin * static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      for (int j = 0; j < size.y; ++j) {
        for (int i = 0; i < size.x; ++i, ++at) {
          if (shows.shows(glm::dvec3(scene.worldFromIndex * glm::dvec4(i, j, k, 1)))) {
            values[at] = static_cast<float>(scene.volume->valueAt({i, j, k}));
          }
        }
      }
    }
  });
  masked.volume = std::make_shared<const ScalarVolume>(scene.volume->grid(), std::move(values));
  masked.whole = masked.volume;
  masked.levelFactor = 1;
  return masked;
}

}  // namespace ocelli
