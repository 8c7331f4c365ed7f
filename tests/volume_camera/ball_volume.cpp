#include "tests/volume_camera/ball_volume.h"

#include <glm/geometric.hpp>
#include <utility>

namespace ocelli::test {

VolumeScene ballVolume(double radius) {
  constexpr int kSide = 33;
  const double step = 2.0 / (kSide - 1);
  VolumeGrid grid{.size = glm::ivec3(kSide)};
  grid.worldFromIndex = glm::dmat4(step);
  grid.worldFromIndex[3] = glm::dvec4(-1, -1, -1, 1);
  std::vector<float> values;
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        values.push_back(static_cast<float>(1 - glm::length(glm::dvec3(grid.worldFromIndex * glm::dvec4(i, j, k, 1)))));
      }
    }
  }
  const glm::dvec3 red(1, 0, 0);
  const double edge = 1 - radius;
  // Opacities are of a slab of 0.01: within a hundredth of the cube nothing is seen through.
  TransferFunction transfer({{edge, red, 0}, {edge, red, TransferFunction::kMaxOpacity}}, 0.01);
  VolumeScene scene{.volume = std::make_shared<ScalarVolume>(grid, std::move(values)),
                    .appearance = {std::move(transfer)}};
  scene.worldFromIndex = grid.worldFromIndex;
  return scene;
}

}  // namespace ocelli::test
