// A cell camera of two viewpoints: the reference, and one from which the wall behind an occluder is seen.
#pragma once

#include "oc_core/camera/cell_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

inline constexpr float kCellSideStep = 0.8f;
inline constexpr float kCellWall = 10.9f;  ///< depth of what the reference sees beside the occluder
inline constexpr float kCellFront = 9.3f;  ///< and of the occluder
/// An occluder in the middle of the reference image, a wall around it.
inline CellCamera::Viewpoint referenceViewpoint() {
  CellCamera::Viewpoint viewpoint{smallCamera(), Image<float>(kWidth, kHeight, kCellWall)};
  for (int y = 20; y < 40; ++y) {
    for (int x = 30; x < 60; ++x) {
      viewpoint.reach(x, y) = kCellFront;
    }
  }
  return viewpoint;
}

/// Sees the wall from the right, and stores the columns in which the occluder hides it from the reference.
inline CellCamera::Viewpoint satelliteViewpoint() {
  const PinholeCamera camera(movedEye(View{}, {kCellSideStep, 0, 0}), kWidth, kHeight);
  CellCamera::Viewpoint viewpoint{camera, Image<float>(kWidth, kHeight, 0)};
  for (int y = 22; y < 38; ++y) {
    for (int x = 50; x < 58; ++x) {
      // The plane of the wall along the direction of this viewpoint.
      const glm::vec3 direction = camera.worldFromCamera(camera.cameraFromImage(
                                      {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 1})) -
                                  camera.eye();
      viewpoint.reach(x, y) = (10 - kCellWall - camera.eye().z) / direction.z;
    }
  }
  return viewpoint;
}

inline const CellCamera& twoViewpoints() {
  static const CellCamera camera({referenceViewpoint(), satelliteViewpoint()});
  return camera;
}

/// Whether a pixel stands in the last row or column of a tile, which the next tile repeats: points there project to
/// that one.
inline bool isRepeated(const glm::vec2& pixel) {
  const int below = static_cast<int>(pixel.y) - twoViewpoints().reference().height();
  return below >= 0 && (static_cast<int>(pixel.x) % CellCamera::kTileSide == CellCamera::kTileSide - 1 ||
                        below % CellCamera::kTileSide == CellCamera::kTileSide - 1);
}

}  // namespace ocelli::test
