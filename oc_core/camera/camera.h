// The contract of every camera model, and the recipe for a new one.
//
// A camera maps world points to image points and pixels to rays. The rays of the cameras of this toolkit bend, so a ray
// is a polyline from near to far; origin plus direction cannot say it.
//
//   project(worldPoint)  -> optional<ImagePoint>   pixel and t; nothing where the point has no image
//   unproject(imagePoint)-> optional<vec3>         nothing where no world point has that image
//   rayPath(pixel)       -> RayPath                empty where the pixel has no ray
//
// t is the parameter of the ray: it grows along it, from near to far, and each camera says what it measures. For those
// that displace the image of a pinhole it is z, the distance along the reference view direction (conventions.h), for
// panoramas the length of the ray, for graph and curved ray cameras what graph_camera.h says. Wherever both succeed,
// project(unproject(q)) is q, and the point of rayPath(p) at parameter t projects to p and t. Renderers
// (oc_core/render) take the camera as a template parameter: no virtual call stands in an inner loop.
//
// Recipe for a new camera model, three places:
//   1. oc_core/camera/NAME_camera.h and .cpp: the class, with its section and equations at the top; it must satisfy
//      Camera.
//   2. tests/camera/camera_contract_test.cpp: add it to the list of cameras that the contract's suite runs over.
//   3. oc_core/ocri/representation_kinds.cpp: a row says its name and how its image is built, so that `--camera NAME`
//      finds it.
// A program outside of the tree needs the class alone, and registers it: examples/add_a_camera.
#pragma once

#include <concepts>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "oc_core/camera/ray_path.h"

namespace ocelli {

/// (u, v) in pixels from the top left corner; t along the ray, as above.
struct ImagePoint {
  float u = 0;
  float v = 0;
  float t = 0;
};

template <class C>
concept Camera = requires(const C& camera, const glm::vec3& worldPoint, const ImagePoint& imagePoint,
                          const glm::vec2& pixel) {
  { camera.width() } -> std::convertible_to<int>;
  { camera.height() } -> std::convertible_to<int>;
  { camera.project(worldPoint) } -> std::same_as<std::optional<ImagePoint>>;
  { camera.unproject(imagePoint) } -> std::same_as<std::optional<glm::vec3>>;
  { camera.rayPath(pixel) } -> std::same_as<RayPath>;
};

}  // namespace ocelli
