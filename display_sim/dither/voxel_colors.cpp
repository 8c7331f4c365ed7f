#include "display_sim/dither/voxel_colors.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {

void sortAndUnite(SliceColors& voxels) {
  std::ranges::sort(voxels, {}, &ColoredVoxel::position);
  size_t kept = 0;
  for (const ColoredVoxel& voxel : voxels) {
    if (kept > 0 && voxels[kept - 1].position == voxel.position) {
      voxels[kept - 1].color = glm::max(voxels[kept - 1].color, voxel.color);
    } else {
      voxels[kept++] = voxel;
    }
  }
  voxels.resize(kept);
}

}  // namespace ocelli
