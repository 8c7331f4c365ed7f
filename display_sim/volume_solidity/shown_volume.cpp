#include "display_sim/volume_solidity/shown_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "display_sim/observing/observer.h"
#include "display_sim/volume_slicing/cell_share.h"
#include "display_sim/volume_solidity/masked_volume.h"
#include "display_sim/volume_solidity/volume_sight.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// The hue that a transfer function has there, at full brightness: one over a wide range of values is nearly black at
/// its beginning, which would leave a surface there without light. White for what is black.
glm::dvec3 surfaceColor(const TransferFunction& transfer, double value) {
  const glm::dvec3 color = transfer.at(value).color;
  const double brightest = std::max({color.x, color.y, color.z});
  return brightest > 0 ? color / brightest : glm::dvec3(1);
}

/// A cell of the sweep, as a block: the half edges from its centre.
class SweptCell {
 public:
  SweptCell(const glm::dvec3& center, const SweepGeometry& sweep) : center_(center) {
    const double radius = std::hypot(center.x, center.z);
    const glm::dvec3 outward = radius > 0 ? glm::dvec3(center.x, 0, center.z) / radius : glm::dvec3(1, 0, 0);
    halfEdges_ = {outward * (sweep.columnWidth() / 2), glm::dvec3(0, sweep.rowHeight() / 2, 0),
                  glm::dvec3(-outward.z, 0, outward.x) * (radius * sweep.tanHalfStep())};
  }

  /// On the shown side of the plane.
  double shareOf(const ClipPlane& clip) const {
    const auto reach = [&](size_t edge) { return std::abs(glm::dot(clip.normal, halfEdges_[edge])); };
    return shareOfBlock(glm::dot(clip.normal, center_) - clip.distance, {reach(0), reach(1), reach(2)});
  }

  /// Of the points in the middles of its eighths.
  double shareOf(const VolumeMask& mask) const {
    int shown = 0;
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec3 point = center_;
      for (int axis = 0; axis < 3; ++axis) {
        point += halfEdges_[static_cast<size_t>(axis)] * ((corner >> axis & 1) != 0 ? 0.5 : -0.5);
      }
      shown += mask.shows(point) ? 1 : 0;
    }
    return shown / 8.0;
  }

 private:
  glm::dvec3 center_;
  std::array<glm::dvec3, 3> halfEdges_{};
};

}  // namespace

void requireSurface(const VolumeScene& scene, double value, const std::string& where) {
  const ValueRange range = valueRange(*scene.volume);
  if (!(value >= range.least && value <= range.greatest)) {
    throw InputError(fmt::format("no surface of this volume has the value {:g}: its values run from {:g} to {:g}",
                                 value, range.least, range.greatest),
                     where, fmt::format("give --iso a value between {:g} and {:g}", range.least, range.greatest));
  }
}

TransferFunction surfaceTransfer(double value, const glm::dvec3& color, const ValueRange& range, double opacityLength) {
  const double width = std::max((range.greatest - range.least) / 1000, 1e-12);
  // So opaque that a way of a thousandth of the length is enough.
  return TransferFunction({{value - width, color, 0}, {value, color, 1}, {value + width, color, 0}},
                          opacityLength / 1000);
}

ShownVolume::ShownVolume(VolumeScene scene, const DisplayProfile& profile, const ShownVolumeOptions& options,
                         const Progress& progress)
    : scene_(std::move(scene)), options_(options) {
  for (const glm::vec3& eye : options_.eyes) {
    checkObserverOptions({.eye = eye}, profile);
  }
  if (options_.cutaway) {
    for (const glm::vec3& eye : options_.eyes) {
      scene_.clips.push_back({-glm::normalize(glm::dvec3(eye)), -*options_.cutaway});
    }
  }
  if (options_.surface) {
    options_.sampling.toldApart.push_back(*options_.surface);
    // Nothing of its transfer function counts but the colour at the value.
    const TransferFunction& transfer = scene_.appearance.transfer;
    scene_.appearance.transfer =
        TransferFunction({{*options_.surface, surfaceColor(transfer, *options_.surface), 1}}, transfer.opacityLength());
  }
  if (options_.light.shown) {
    options_.sampling.toldApart.insert(options_.sampling.toldApart.end(),
                                       {options_.light.shown->least, options_.light.shown->greatest});
  }
  samples_ = std::make_unique<SweptSamples>(scene_, profile, options_.sampling, progress);
  light_ = std::make_unique<SweptLight>(lightOf(scene_.appearance.transfer));
  if (options_.surface) {
    scene_.appearance.transfer = surfaceTransfer(*options_.surface, scene_.appearance.transfer.at(0).color,
                                                 samples_->range(), scene_.volume->grid().meanSpacing());
  }
  if (!scene_.clips.empty() || options_.mask != nullptr || options_.seenOpacity) {
    samples_->setPart(partOf(options_, progress), progress);
  }
}

SweptLight ShownVolume::lightOf(const TransferFunction& transfer) const {
  if (options_.surface) {
    return SweptLight::ofSurface(*options_.surface, surfaceColor(transfer, *options_.surface), samples_->range(),
                                 samples_->sweep());
  }
  return {transfer, samples_->range(), samples_->sceneLengthOfUnit(), samples_->sweep(), options_.light};
}

VolumeScene ShownVolume::seenScene() const {
  return maskedScene(scene_, options_.mask.get(), options_.surface ? std::nullopt : options_.light.shown,
                     samples_->range());
}

SweptSamples::Part ShownVolume::partOf(const ShownVolumeOptions& options, const Progress& progress) const {
  std::shared_ptr<const VolumeMask> mask;
  if (options.mask != nullptr) {
    mask = std::make_shared<VolumeMask>(*options.mask);
  }
  std::shared_ptr<const VolumeSight> sight;
  if (options.seenOpacity && !options.eyes.empty()) {
    const VolumeRenderer renderer(seenScene(), {.depthOpacity = *options.seenOpacity});
    sight = std::make_shared<VolumeSight>(renderer, options.eyes, samples_->profile().height, progress);
  }
  // Eyes look at the middle of a cell, where its light stands, and at what it shows: of one that a face cuts, whose
  // middle may lie beside the volume, at a place half a cell within.
  const glm::dmat4 worldFromIndex = scene_.worldFromIndex;
  const glm::dmat4 indexFromWorld = glm::inverse(worldFromIndex);
  const glm::dvec3 size(scene_.volume->grid().size);
  const auto within = [worldFromIndex, indexFromWorld, size](const glm::dvec3& center, double cellSide) {
    glm::dvec3 index = indexFromWorld * glm::dvec4(center, 1);
    for (int axis = 0; axis < 3; ++axis) {
      const double half = std::min(cellSide / 2 / glm::length(glm::dvec3(worldFromIndex[axis])), size[axis] / 2);
      index[axis] = std::clamp(index[axis], -0.5 + half, size[axis] - 0.5 - half);
    }
    return glm::dvec3(worldFromIndex * glm::dvec4(index, 1));
  };
  return [&clips = scene_.clips, &sweep = samples_->sweep(), mask, sight, within](const glm::dvec3& center,
                                                                                  double cellSide) {
    const SweptCell cell(center, sweep);
    double share = 1;
    for (const ClipPlane& clip : clips) {
      share *= cell.shareOf(clip);
    }
    if (share == 0 ||
        (sight != nullptr && !(sight->sees(center, cellSide) && sight->sees(within(center, cellSide), cellSide)))) {
      return 0.0;
    }
    return mask == nullptr ? share : share * cell.shareOf(*mask);
  };
}

}  // namespace ocelli
