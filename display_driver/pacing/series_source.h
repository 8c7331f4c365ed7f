// A numbered series of meshes, one after the other at a rate: an animation.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/pacing/volume_source.h"
#include "display_sim/slicing/slice_mesh.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/progress.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

/// Files of a folder whose names hold a number before their ending, which they share, in the order of the numbers:
/// walk_1.ply, walk_2.ply, ..., walk_10.ply. Throws InputError where there is none, or two have the same number.
std::vector<std::filesystem::path> numberedFiles(const std::filesystem::path& folder, const std::string& ending);

class SeriesSource final : public VolumeSource {
 public:
  /// Reads all meshes now. Where `scene.fit` holds, one scale and translation that fits the whole series is used for
  /// all of them. Throws InputError as loadScene() does.
  SeriesSource(const std::vector<std::filesystem::path>& files, const SceneOptions& scene,
               const DisplayProfile& profile, const SliceOptions& options, double meshesPerSecond, bool loop,
               const Progress& progress = {});

  SourcedVolume volumeFor(HostTime seen) override;

  /// Whether a part of some mesh lies outside of the display, and is not shown.
  bool isCutOff() const { return cutOff_; }

 private:
  std::vector<SliceMesh> meshes_;
  bool cutOff_ = false;
  Slicer slicer_;
  double meshesPerSecond_;
  bool loop_;
  std::optional<HostTime> start_;
  std::optional<size_t> mesh_;
};

}  // namespace ocelli
