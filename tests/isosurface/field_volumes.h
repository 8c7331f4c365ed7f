// Volumes of fields that are given as functions of index coordinates.
#pragma once

#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_scene.h"

namespace ocelli {

template <class Field>
std::vector<float> sampledField(const glm::ivec3& size, const Field& field) {
  std::vector<float> values;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) {
        values.push_back(static_cast<float>(field(glm::dvec3(i, j, k))));
      }
    }
  }
  return values;
}

inline VolumeScene sceneOf(ScalarVolume volume, const glm::dmat4& worldFromIndex = glm::dmat4(1)) {
  return {.volume = std::make_shared<ScalarVolume>(std::move(volume)),
          .worldFromIndex = worldFromIndex,
          .appearance = {.transfer = TransferFunction({{0, {0.25, 0.5, 1}, 0}, {1, {0.25, 0.5, 1}, 0.5}}, 1)}};
}

/// The index coordinates are the world.
template <class Field>
VolumeScene sceneOfField(const glm::ivec3& size, const Field& field) {
  return sceneOf(ScalarVolume({.size = size}, sampledField(size, field)));
}

}  // namespace ocelli
