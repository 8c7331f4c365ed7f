// By how much what a graph camera shows moves in the image from frame to frame, whatever it looks like: where the
// points are in the next frame that one frame shows. What moves is not what changes: an image with more detail changes
// more by the same motion.
#pragma once

#include <glm/geometric.hpp>
#include <optional>

#include "oc_core/camera/graph_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli::test {

inline bool samePlane(const Plane& one, const Plane& other) {
  return glm::distance(one.normal, other.normal) + std::abs(one.distance - other.distance) < 1e-9;
}

/// Where a point that a frame showed at a pixel is in the next frame: behind the plane that it was behind. So what a
/// portal shows is followed in that portal. Nothing where the next frame does not show the place. The cameras are
/// bends of the root alone.
inline std::optional<glm::dvec2> followed(const GraphCamera& before, const glm::vec2& pixel, const glm::dvec3& point,
                                          const GraphCamera& now) {
  const int child = before.childAt(GraphCamera::kRoot, pixel);
  const Plane* behind = child < 0 ? nullptr : &before.frusta()[static_cast<size_t>(child)].plane;
  if (behind != nullptr && behind->height(point) <= 0) {
    behind = nullptr;  // it lies before the bend
  }
  for (size_t i = 0; i < now.frusta().size(); ++i) {
    const GraphCamera::Frustum& frustum = now.frusta()[i];
    if (behind != nullptr ? i == 0 || !samePlane(frustum.plane, *behind) : i > 0) {
      continue;
    }
    const glm::dvec4 image = frustum.pixelFromWorld * glm::dvec4(point, 1);
    const glm::dvec2 there = glm::dvec2(image) / image.w;
    if (!(image.w > 0 && there.x >= 0 && there.y >= 0 && there.x < now.width() && there.y < now.height())) {
      continue;
    }
    const int taken = now.childAt(GraphCamera::kRoot, there);
    const bool shown = behind != nullptr
                           ? taken == static_cast<int>(i)
                           : taken < 0 || now.frusta()[static_cast<size_t>(taken)].plane.height(point) <= 0;
    if (shown) {
      return there;
    }
  }
  return std::nullopt;
}

/// Pixels, the mean over every fourth pixel of an image of samples x samples rays a pixel: of what both frames show.
/// Where there is no surface, the end of the ray is followed.
inline double meanMotion(const GraphCamera& before, const FragmentImage& fragments, const Mesh& mesh,
                         const GraphCamera& now, int samples) {
  double sum = 0;
  size_t count = 0;
  for (int y = samples; y < fragments.height(); y += 2 * samples) {
    for (int x = samples; x < fragments.width(); x += 2 * samples) {
      const Fragment& fragment = fragments(x, y);
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const glm::vec3 point = fragment.covered() ? positionOf(fragment, mesh) : before.rayPath(pixel).back();
      if (const auto there = followed(before, pixel, glm::dvec3(point), now)) {
        sum += glm::distance(*there, glm::dvec2(pixel)) / samples;
        ++count;
      }
    }
  }
  return sum / static_cast<double>(std::max<size_t>(count, 1));
}

}  // namespace ocelli::test
