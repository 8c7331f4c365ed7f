// What is left of a volume where a mask shows a part of it: as if the rest were not there, so that it hides nothing.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// A second volume whose voxels of 0.5 or more are shown.
class VolumeMask {
 public:
  /// `scene` must outlive it.
  explicit VolumeMask(const VolumeScene& scene);

  /// Whether the nearest voxel is set; outside of the mask none is.
  bool shows(const glm::dvec3& point) const;

 private:
  const ScalarVolume& volume_;
  glm::dmat4 indexFromScene_;
};

/// `mask`, which stands in its own world as its file says, moved to where `scene` is: the same place of the world of
/// both grids, or of both patients, is the same place of the scene.
VolumeScene placedMask(VolumeScene mask, const VolumeScene& scene);

/// The same, but for values outside of `shown`, which have no opacity.
TransferFunction transferWithin(const TransferFunction& transfer, const ValueRange& shown);

/// `scene` without the values outside of `shown`, and without the voxels whose centres `mask` does not show: these get
/// a value far below `told`, which has no opacity. Between a voxel that is shown and one that is not nearly nothing is
/// left, so that what is shown ends at the centres of its outermost voxels, half a voxel early. `told` is the range of
/// the values that matter (SweptSamples::range()). A mask copies the volume, in single precision.
VolumeScene maskedScene(const VolumeScene& scene, const VolumeScene* mask, const std::optional<ValueRange>& shown,
                        const ValueRange& told);

}  // namespace ocelli
