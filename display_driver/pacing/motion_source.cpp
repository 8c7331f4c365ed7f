#include "display_driver/pacing/motion_source.h"

#include <utility>

#include "display_sim/slicing/display_bounds.h"

namespace ocelli {

MotionSource::MotionSource(std::unique_ptr<SceneMotion> motion, const DisplayProfile& profile,
                           const SliceOptions& options, const MotionPlayback& playback)
    : motion_(std::move(motion)), clock_(motion_->durationSeconds(), playback), slicer_(profile, options) {
  for (const double time : motion_->sampleTimes()) {
    const Mesh& mesh = motion_->at(time);
    cutOff_ = cutOff_ || !liesWithin(mesh, profile);
    if (!meshes_.contains(motion_->topology())) {
      Mesh ordered = mesh;
      ordered.triangles = trianglesForSlicing(mesh);
      meshes_.emplace(motion_->topology(), SliceMesh(ordered));
    }
  }
}

SourcedVolume MotionSource::volumeFor(HostTime seen) {
  const std::optional<double> seconds = clock_.at(seen);
  if (!seconds) {
    return {};
  }
  const Mesh& mesh = motion_->at(*seconds);
  const std::pair now(motion_->topology(), motion_->shape());
  if (shown_ == now) {
    return {.kind = SourcedVolume::Kind::kSame};
  }
  shown_ = now;
  SliceMesh& sliced = meshes_.at(now.first);
  sliced.setPositions(mesh.positions);
  sliced.setColors(mesh.colors);
  slicer_.slice(sliced);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
