// Reference images of cameras that displace no pinhole's image: graph cameras, curved rays, panoramas. Each sample says
// where it is, and how far along its ray; the camera is not needed to mesh it.
#pragma once

#include "oc_core/camera/ray_length.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

/// `fragments` are what a renderer left for the camera. `view` is the one that it was made for. `wrapsAround`: whether
/// the last column is next to the first.
template <Camera C>
ReferenceImage placedImage(const C& camera, const FragmentImage& fragments, const Mesh& mesh, const View& view,
                           const std::string& name, bool wrapsAround = false) {
  const int width = fragments.width();
  const int height = fragments.height();
  ReferenceImage image{name, view, Image<glm::vec3>(width, height), Image<float>(width, height),
                       Image<glm::vec2>(width, height)};
  image.position = Image<glm::vec3>(width, height);
  image.direction = Image<glm::vec3>(width, height);
  image.wrapsAround = wrapsAround;
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        const Fragment& fragment = fragments(x, y);
        if (!fragment.covered()) {
          continue;
        }
        const glm::vec3 point = positionOf(fragment, mesh);
        const PlaceOnRay place =
            placeOnRay(camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}), point);
        if (place.length > 0) {
          image.color(x, y) = colorOf(fragment, mesh);
          image.z(x, y) = view.zNear + place.length;
          image.position(x, y) = point;
          image.direction(x, y) = place.direction;
        }
      }
    }
  });
  return image;
}

/// The same by casting its rays.
template <Camera C>
ReferenceImage placedImage(const C& camera, const Mesh& mesh, const RayScene& rays, const View& view,
                           const std::string& name, bool wrapsAround = false) {
  return placedImage(camera, raycast(camera, mesh, rays), mesh, view, name, wrapsAround);
}

}  // namespace ocelli
