// Volumes for tests of renderers, made from formulas.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_scene.h"
#include "tests/volume/field_volume.h"

namespace ocelli::test {

/// The middle of the voxels is at the origin of the scene; each holds what `number` says of its index.
template <class Voxel, class Number>
VolumeScene volumeAlong(const glm::dmat3& axes, const glm::ivec3& size, VoxelType type, const Number& number,
                        TransferFunction transfer, double scale = 1, double offset = 0) {
  VolumeGrid grid;
  grid.size = size;
  grid.worldFromIndex = glm::dmat4(axes) * glm::translate(glm::dmat4(1), -(glm::dvec3(size) - 1.0) / 2.0);
  return {.volume =
              std::make_shared<ScalarVolume>(volumeOfVoxels(grid, type, voxelsOf<Voxel>(size, number), scale, offset)),
          .worldFromIndex = grid.worldFromIndex,
          .appearance = {std::move(transfer), {}}};
}

/// `size` voxels, `spacing` apart.
template <class Voxel, class Number>
VolumeScene volumeOf(const glm::ivec3& size, double spacing, VoxelType type, const Number& number,
                     TransferFunction transfer, double scale = 1, double offset = 0) {
  return volumeAlong<Voxel>(glm::dmat3(spacing), size, type, number, std::move(transfer), scale, offset);
}

template <class Number>
VolumeScene floatVolume(const glm::ivec3& size, double spacing, const Number& number, TransferFunction transfer) {
  return volumeOf<float>(size, spacing, VoxelType::kFloat32, number, std::move(transfer));
}

/// Any value: an opacity, in one colour.
inline TransferFunction everywhere(double opacity, double length, const glm::dvec3& color = {0.8, 0.4, 0.2}) {
  return TransferFunction({{0, color, opacity}}, length);
}

/// Waves, with smooth surfaces in all directions and what is empty between them; values in [-1, 1].
inline double wavesAt(const glm::dvec3& index) {
  return std::sin(index.x * 0.31) * std::cos(index.y * 0.23 + 1) * std::sin(index.z * 0.27 + 0.5);
}
/// A dense layer, and a faint one, before nothing.
inline TransferFunction layers(double length) {
  return TransferFunction({{0.1, {0.1, 0.2, 0.9}, 0},
                           {0.3, {0.2, 0.6, 0.9}, 0.03},
                           {0.4, {0.9, 0.2, 0.1}, 0},
                           {0.6, {0.9, 0.8, 0.1}, 0.5},
                           {0.9, {1, 1, 1}, 0.8}},
                          length);
}
inline VolumeScene waves(bool isShaded = true) {
  // 48 voxels of 1/24 fill the cube of half side 1.
  VolumeScene scene = floatVolume(glm::ivec3(48, 44, 40), 1.0 / 24, wavesAt, layers(1.0 / 12));
  scene.appearance.shading.isOn = isShaded;
  return scene;
}
/// Waves of the same lengths, in voxels of 1 to 1 to 3 whose axes are not perpendicular, and mirror.
inline VolumeScene slantedWaves(bool isShaded) {
  const glm::dmat3 axes(glm::dvec3(-1, 0, 0) / 24.0, glm::dvec3(0.4, 0.9, 0.1) / 24.0,
                        glm::dvec3(0.5, -0.7, 2.9) / 24.0);
  const auto number = [](const glm::dvec3& p) { return wavesAt({p.x, p.y, 3 * p.z}); };
  VolumeScene scene = volumeAlong<float>(axes, {48, 44, 14}, VoxelType::kFloat32, number, layers(1.0 / 12));
  scene.appearance.shading.isOn = isShaded;
  return scene;
}

}  // namespace ocelli::test
