// Reference images of cameras that displace no pinhole's image: graph cameras, curved rays, panoramas. Each sample says
// where it is, and the parameter of its ray there; the camera is not needed to mesh it.
#pragma once

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
  ReferenceImage image = blankReferenceImage(name, view, width, height, true);
  image.wrapsAround = wrapsAround;
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        const Fragment& fragment = fragments(x, y);
        if (!fragment.covered()) {
          continue;
        }
        const RayPath ray = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        if (ray.size() > 1) {
          image.set(x, y, fragment.t, colorOf(fragment, mesh));
          image.position(x, y) = positionOf(fragment, mesh);
          image.direction(x, y) = ray.directionAt(ray.positionAt(fragment.t));
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
