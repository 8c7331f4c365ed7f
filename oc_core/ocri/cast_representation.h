// The row of a camera whose image is cast along its rays: any class that satisfies Camera (oc_core/camera/camera.h) is
// one, without further code.
//
//   registerRepresentation(castRepresentation("fisheye", "half a sphere around the view direction",
//                                             [](const RepresentationInputs& in) { return Fisheye(in.reference); }));
#pragma once

#include <memory>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/camera/ray_hull.h"
#include "oc_core/camera/ray_smoothness.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {

/// Whether the last column of a camera's image is next to the first, where the camera itself says so.
template <Camera C>
bool cameraWrapsAround(const C& camera) {
  if constexpr (requires { camera.wrapsAround(); }) {
    return camera.wrapsAround();
  } else if constexpr (requires { C::kWrapsAround; }) {
    return C::kWrapsAround;
  } else {
    return false;
  }
}

/// The map of a camera, whose functions keep it.
template <Camera C>
CameraMap mapOf(C camera) {
  const auto shared = std::make_shared<const C>(std::move(camera));
  return {[shared](const glm::vec2& pixel) { return shared->rayPath(pixel); },
          [shared](const glm::vec3& worldPoint) { return shared->project(worldPoint); },
          {shared->width(), shared->height()},
          rayHullOf(shared),
          cameraWrapsAround(*shared),
          kHasSmoothRays<C>};
}

/// How every camera can be drawn: along its rays, by the renderer, where it casts some.
template <Camera C>
FragmentImage castAlongRays(const C& camera, const RepresentationInputs& in) {
  std::optional<FragmentImage> cast =
      in.renderer != nullptr ? in.renderer->drawAlong(raysOfCamera(camera)) : std::nullopt;
  return cast ? *std::move(cast) : raycast(camera, in.mesh, RayScene(in.mesh));
}

/// `makeCamera` makes the camera from RepresentationInputs. `wrapsAround`: whether the last column of its image is next
/// to the first. Both texts must stay until the program ends.
template <class MakeCamera>
RepresentationKind castRepresentation(const char* name, const char* description, MakeCamera makeCamera,
                                      bool wrapsAround = false) {
  using Inputs = RepresentationInputs;
  const auto cast = [makeCamera, wrapsAround](const Inputs& in) {
    const auto camera = makeCamera(in);
    return placedImage(camera, castAlongRays(camera, in), in.mesh, in.reference.view(), in.choice.name, wrapsAround);
  };
  return {.name = name,
          .description = description,
          .images = [cast](const Inputs& in) -> ReferenceImages { return {cast(in)}; },
          .rayCrossover = 0,
          .draw =
              [cast](Technique technique, const Inputs& in) {
                if (technique != Technique::kRaycast) {
                  throw InputError("camera \"" + in.choice.name + "\" is drawn by ray casting", "--method",
                                   "use raster or raycast");
                }
                return cast(in);
              },
          .maps = [makeCamera, wrapsAround](const Inputs& in, const ReferenceImages&) -> std::vector<CameraMap> {
            CameraMap map = mapOf(makeCamera(in));
            map.wrapsAround = wrapsAround;
            return {std::move(map)};
          },
          .castsRays = true};
}

}  // namespace ocelli
