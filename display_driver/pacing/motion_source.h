// A moving scene, sliced anew for each refresh in which it has another shape.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "display_driver/pacing/motion_clock.h"
#include "display_driver/pacing/volume_source.h"
#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {

class MotionSource final : public VolumeSource {
 public:
  /// Looks at all of the motion's sample times now, and puts the triangles of each of its topologies in order for the
  /// slicer. Positions are in display radii.
  MotionSource(std::unique_ptr<SceneMotion> motion, const DisplayProfile& profile, const SliceOptions& options,
               const MotionPlayback& playback);

  SourcedVolume volumeFor(HostTime seen) override;

  /// Whether a part of it lies outside of the display at some of the sample times, and is not shown.
  bool isCutOff() const { return cutOff_; }

 private:
  std::unique_ptr<SceneMotion> motion_;
  MotionClock clock_;
  std::map<uint64_t, SliceMesh> meshes_;  ///< by topology
  bool cutOff_ = false;
  Slicer slicer_;
  std::optional<std::pair<uint64_t, uint64_t>> shown_;  ///< topology and shape
};

}  // namespace ocelli
