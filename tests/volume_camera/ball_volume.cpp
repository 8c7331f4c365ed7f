#include "tests/volume_camera/ball_volume.h"

#include <glm/geometric.hpp>

#include "tests/volume/field_volume.h"

namespace ocelli::test {

VolumeScene ballVolume(double radius) {
  constexpr int kSide = 33;
  // The outermost centres are at -1 and 1.
  const VolumeGrid grid = gridOfCube(kSide, 1 + 1.0 / (kSide - 1));
  const glm::dvec3 red(1, 0, 0);
  const double edge = 1 - radius;
  // Opacities are of a slab of 0.01: within a hundredth of the cube nothing is seen through.
  return sceneOfVoxels(grid, voxelsInWorld(grid, [](const glm::dvec3& p) { return 1 - glm::length(p); }),
                       TransferFunction({{edge, red, 0}, {edge, red, TransferFunction::kMaxOpacity}}, 0.01));
}

}  // namespace ocelli::test
