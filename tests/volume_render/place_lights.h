// What a renderer's copy of the lighting rule (oc_core/volume/gradient_light.h) gives, place by place, beside the rule
// itself: of volumes so dense that the first step of a ray takes all light, the colour of a pixel is that of one place.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/volume_render/ray_pieces.h"
#include "oc_core/volume_render/volume_image.h"
#include "oc_core/volume_render/volume_lighting.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli::test {

struct LightCase {
  std::string name;
  VolumeScene scene;
};

inline constexpr double kPlaceStep = 0.25;  ///< of the images, in mean distances of voxels
inline const glm::dvec3 kPlaceColor(0.6, 0.3, 0.1);

inline VolumeRenderOptions placeOptions() {
  return {.step = kPlaceStep, .endTransmittance = 0, .skipEmpty = false};
}

/// Waves that are cut off at 0: places with a direction, flat ones, and what lies between.
inline double wavesAboveZero(const glm::dvec3& index) {
  return std::max(wavesAt(index), 0.0);
}

/// Kinds of voxels, of axes and of light. Of each voxel the step is so deep that 1e-30 of the light passes.
inline std::vector<LightCase> lightCases() {
  const glm::ivec3 size(40, 36, 32);
  const auto dense = [](double spacing) {
    return everywhere(TransferFunction::kMaxOpacity, kPlaceStep * spacing / 8, kPlaceColor);
  };
  const glm::dmat3 slanted(glm::dvec3(-1, 0, 0) / 24.0, glm::dvec3(0.4, 0.9, 0.1) / 24.0,
                           glm::dvec3(0.5, -0.7, 2.9) / 24.0);
  const auto steps = [](const glm::dvec3& p) { return std::round(30000 * wavesAboveZero(p)); };
  std::vector<LightCase> cases{
      {"waves", floatVolume(size, 1.0 / 20, wavesAboveZero, dense(1.0 / 20))},
      {"slanted axes", volumeAlong<float>(
                           slanted, {40, 36, 12}, VoxelType::kFloat32,
                           [](const glm::dvec3& p) {
                             return wavesAboveZero({p.x, p.y, 3 * p.z});
                           },
                           dense(1.0 / 20))},
      {"falling values", volumeOf<int16_t>(size, 1.0 / 20, VoxelType::kInt16, steps, dense(1.0 / 20), -1.0 / 30000, 1)},
      {"double voxels", volumeOf<double>(size, 1.0 / 20, VoxelType::kFloat64, wavesAboveZero, dense(1.0 / 20))}};
  const std::vector<VolumeShading> shadings{
      {.isOn = true},
      {.isOn = true, .ambient = 0.1, .diffuse = 0.4, .specular = 0.5, .shininess = 3},
      {.isOn = true, .ambient = 0.3, .diffuse = 0.6, .specular = 0, .shininess = 20},
      {.isOn = true, .ambient = 0, .diffuse = 0, .specular = 1, .shininess = 90}};
  std::vector<LightCase> all;
  for (const LightCase& each : cases) {
    for (size_t i = 0; i < shadings.size(); ++i) {
      LightCase& made = all.emplace_back(each);
      made.name += ", shading " + std::to_string(i);
      made.scene.appearance.shading = shadings[i];
    }
  }
  return all;
}

/// From where all three visible faces are seen.
inline PinholeCamera placeCamera() {
  View view;
  view.eye = {3, 2, 4};
  view.fovVerticalDegrees = 25;
  return {view, 48, 36};
}

/// `image` is what placeCamera() sees of the scene with placeOptions(). Coordinates of places are single, of 40 voxels:
/// 4e-6; the sharpest highlight is 90 times as steep as its cosine, and gradients turn by up to a fifth over a voxel:
/// 1e-4. What is left of 3e-4 is for what floats lose of gradients that are nearly flat.
inline void expectPlaceLights(const VolumeImage& image, const LightCase& expected) {
  const VolumeScene& scene = expected.scene;
  const PinholeCamera camera = placeCamera();
  const VolumeExtent extent(scene);
  const VolumeLighting lighting(scene, valueRange(*scene.volume));
  const double step = kPlaceStep * scene.volume->grid().meanSpacing();
  double worst = 0;
  size_t lit = 0;
  size_t unlit = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      VolumeExtent::Pieces pieces;
      const RayPath ray = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      if (extent.cut(ray, std::numeric_limits<double>::infinity(), pieces) == 0 || pieces[0].length < step) {
        continue;
      }
      const VolumeRayPiece& piece = pieces[0];
      const PlaceLight<double> light = lighting.at(piece.from + piece.way * (step / 2), piece.direction);
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(image(x, y).color[c] - (kPlaceColor[c] * light.factor + light.added)));
      }
      (light.factor == 1 && light.added == 0 ? unlit : lit) += 1;
    }
  }
  EXPECT_LT(worst, 3e-4) << expected.name;
  EXPECT_GT(lit, 100u) << expected.name;
  EXPECT_GT(unlit, 20u) << expected.name << ": places that are flat";
  testing::Test::RecordProperty(expected.name, std::to_string(worst));
}

}  // namespace ocelli::test
