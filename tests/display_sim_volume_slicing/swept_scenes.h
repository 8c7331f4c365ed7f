// Volumes of fields, on small displays, for the tests of this room.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli::test {

/// A field over the cube of this half side around the origin of the display, by so many voxels a side.
inline VolumeScene sceneOfField(int size, double halfSide, const std::function<double(const glm::dvec3&)>& field,
                                TransferFunction transfer) {
  VolumeGrid grid;
  grid.size = glm::ivec3(size);
  const double step = 2 * halfSide / size;
  const double first = step / 2 - halfSide;
  grid.worldFromIndex = glm::dmat4(glm::dvec4(step, 0, 0, 0), glm::dvec4(0, step, 0, 0), glm::dvec4(0, 0, step, 0),
                                   glm::dvec4(first, first, first, 1));
  std::vector<float> values;
  for (int k = 0; k < size; ++k) {
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        values.push_back(static_cast<float>(field(glm::dvec3(grid.worldFromIndex * glm::dvec4(i, j, k, 1)))));
      }
    }
  }
  const glm::dmat4 worldFromIndex = grid.worldFromIndex;
  return {.volume = std::make_shared<ScalarVolume>(std::move(grid), std::move(values)),
          .worldFromIndex = worldFromIndex,
          .appearance = {std::move(transfer)}};
}

inline DisplayProfile sweptProfile(int slices, int width, int height, int bits = 1,
                                   SecondHalfTurn secondHalfTurn = SecondHalfTurn::kMirrored) {
  DisplayProfile profile = loadProfile("test");
  profile.name = "swept";
  profile.slicesPerHalfTurn = slices;
  profile.width = width;
  profile.height = height;
  profile.colorBitsPerChannel = bits;
  profile.secondHalfTurn = secondHalfTurn;
  return profile;
}

}  // namespace ocelli::test
