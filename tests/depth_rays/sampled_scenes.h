// Reference images of all kinds of a small scene, and random rays at them.
#pragma once

#include <functional>

#include "oc_core/base/random.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/placed_image.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli::test {

/// Balls and a box in front of a wall: curved rims, planes along the axes, one behind the other.
inline Mesh thingsBeforeWall() {
  Mesh mesh = boxBeforeWall(2);
  Mesh ball = makeSphere(24);
  paint(ball, {0.1f, 0.2f, 0.8f});
  append(mesh, ball, glm::scale(glm::translate(glm::mat4(1), {-0.6f, 0.2f, 0.1f}), glm::vec3(0.25f)));
  append(mesh, ball, glm::scale(glm::translate(glm::mat4(1), {0.5f, -0.4f, -0.3f}), glm::vec3(0.3f)));
  return mesh;
}

/// Calls `visit(name, images)` for each kind that has images, and for a graph camera.
inline void forEachSampledScene(const Mesh& mesh, const PinholeCamera& camera,
                                const std::function<void(const std::string& name, const ReferenceImages&)>& visit) {
  for (const CameraName& name : cameraNames()) {
    const CameraChoice choice = cameraChoice(name.name);
    if (choice.hasImages()) {
      visit(name.name, buildReferenceImages(choice, camera, mesh));
    }
  }
  visit("graph camera", {placedImage(crossroads(camera), mesh, RayScene(mesh), camera.view(), "graph camera")});
}

/// A third of the rays runs towards the middle, a third along an axis or an axis' plane, the others anywhere. They
/// begin around the scene, or in the midst of it.
inline RayPath randomRay(Random& random) {
  const auto point = [&](float half) {
    return glm::vec3(random.inRange(-half, half), random.inRange(-half, half), random.inRange(-half, half));
  };
  const glm::vec3 origin = point(random.below(2) == 0 ? 1.0f : 4.0f);
  glm::vec3 direction = point(1);
  switch (random.below(3)) {
    case 0:
      direction = point(1) - origin;
      break;
    case 1:
      direction[static_cast<int>(random.below(3))] = 0;
      direction[static_cast<int>(random.below(3))] = 0;
      break;
    default:
      break;
  }
  return {origin, origin + direction * 20.0f};
}

}  // namespace ocelli::test
