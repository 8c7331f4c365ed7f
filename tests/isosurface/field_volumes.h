// Volumes whose index coordinates are the world, for tests of their surfaces.
#pragma once

#include <utility>

#include "tests/volume/field_volume.h"

namespace ocelli {

inline VolumeScene sceneOf(ScalarVolume volume, const glm::dmat4& worldFromIndex = glm::dmat4(1)) {
  return {.volume = std::make_shared<ScalarVolume>(std::move(volume)),
          .worldFromIndex = worldFromIndex,
          .appearance = {.transfer = TransferFunction({{0, {0.25, 0.5, 1}, 0}, {1, {0.25, 0.5, 1}, 0.5}}, 1)}};
}

template <class Field>
VolumeScene sceneOfField(const glm::ivec3& size, const Field& field) {
  return sceneOf(ScalarVolume({.size = size}, test::voxelsOf(size, field)));
}

}  // namespace ocelli
