// Scenes, views and images for the tests of the client.
#pragma once

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

inline const Mesh& clientStatues() {
  static const Mesh mesh = loadScene("builtin:statues");
  return mesh;
}

inline GpcLayout clientLayout(float zoom) {
  return {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.5f, 0.5f}, zoom, 1}}};
}

/// The scene from its usual viewpoint.
inline View clientView(double fovDegrees) {
  View view;
  view.fovVerticalDegrees = fovDegrees;
  return view;
}

inline ReferenceImage clientImage(const View& view, const glm::ivec2& size, const GpcLayout& layout,
                                  const Mesh& mesh = clientStatues()) {
  CameraChoice choice = cameraChoice("gpc");
  choice.gpc = layout;
  return buildReferenceImages(choice, PinholeCamera(view, size.x, size.y), mesh).front();
}

/// Turned by so many degrees to the right and up.
inline View clientTurned(View view, double right, double up) {
  const PinholeCamera camera(view, 16, 9);
  const auto x = static_cast<float>(std::tan(radiansFromDegrees(right)));
  const auto y = static_cast<float>(std::tan(radiansFromDegrees(up)));
  view.target = view.eye + (camera.forward() + camera.right() * x - camera.down() * y) * 10.0f;
  return view;
}

}  // namespace ocelli
