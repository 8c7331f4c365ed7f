// Which lit voxels of a volume an eye would see, were the surfaces of the scene opaque.
//
// A voxel stands for the point of the scene's surface that is closest to its centre, or for the centre where no surface
// lies within kVoxelReach voxels of it. It is hidden from an eye where the straight line to that point meets the scene
// more than kVoxelReach voxels before it: what is nearer to a visible surface cannot be told from it on the display. A
// voxel here is as large as the longest side of its cell.
#pragma once

#include <vector>

#include "display_sim/frames/volume.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

inline constexpr double kVoxelReach = 1.5;

class VoxelVisibility {
 public:
  /// `scene` must outlive it.
  VoxelVisibility(const Volume& volume, const RayScene& scene);

  /// The voxels of the volume that are hidden from `eye`; all others are dark. The same with any number of threads.
  Volume hiddenFrom(const glm::vec3& eye) const;

 private:
  struct LitVoxel {
    int column;
    int row;
    Rgb8 levels;
    glm::vec3 point;  ///< that it stands for
    float reach;
  };

  DisplayProfile profile_;
  const RayScene& scene_;
  std::vector<std::vector<LitVoxel>> slices_;
};

}  // namespace ocelli
