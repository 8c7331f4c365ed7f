// Which pixels of a camera that displaces the image of a pinhole see just what the pinhole sees: those that no
// displacement reaches. Their rays are the pinhole's, and need not be cast again.
#pragma once

#include <cmath>

#include "oc_core/camera/distorted_pinhole.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

/// 1 for the pixels that the image of some displaced point may fall on, whatever its depth; never too few.
template <DistortedPinhole C>
Image<uint8_t> displacementReach(const C& camera) {
  const int width = camera.width();
  const int height = camera.height();
  const float beyond = camera.longestDisplacement() + 1;  // what is displaced into the image from outside
  const float inverseNear = 1 / camera.reference().view().zNear;
  // Each pixel's points are displaced into a rectangle; how many of these begin less end, above and to the left.
  Image<int> steps(width + 1, height + 1, 0);
  const auto clampedPixel = [](float place, int count) {
    return static_cast<int>(glm::clamp(std::floor(place), 0.0f, static_cast<float>(count)));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
      ImageBox box{corner, corner + 1.0f};
      if (!displacesWithin(camera, box)) {
        continue;
      }
      ImageBox displacement = camera.displacementOver(box, 0, inverseNear);
      displacement = {glm::min(displacement.lower, 0.0f), glm::max(displacement.upper, 0.0f)};
      box.lower -= glm::vec2(x == 0, y == 0) * beyond;
      box.upper += glm::vec2(x + 1 == width, y + 1 == height) * beyond;
      const int x0 = clampedPixel(box.lower.x + displacement.lower.x, width);
      const int y0 = clampedPixel(box.lower.y + displacement.lower.y, height);
      const int x1 = clampedPixel(box.upper.x + displacement.upper.x + 1, width);
      const int y1 = clampedPixel(box.upper.y + displacement.upper.y + 1, height);
      ++steps(x0, y0);
      --steps(x1, y0);
      --steps(x0, y1);
      ++steps(x1, y1);
    }
  }
  Image<uint8_t> reach(width, height, 0);
  for (int y = 0; y < height; ++y) {
    int inRow = 0;
    for (int x = 0; x < width; ++x) {
      inRow += steps(x, y);
      steps(x, y) = inRow + (y > 0 ? steps(x, y - 1) : 0);
      reach(x, y) = steps(x, y) > 0;
    }
  }
  return reach;
}

/// Of what the pinhole sees, the pixels that no displacement reaches.
template <DistortedPinhole C>
FragmentImage unreachedPart(const C& camera, const FragmentImage& seen) {
  FragmentImage part = seen;
  const Image<uint8_t> reach = displacementReach(camera);
  for (size_t i = 0; i < part.size(); ++i) {
    part[i] = reach[i] != 0 ? Fragment{} : part[i];
  }
  return part;
}

/// The closest fragment along the ray of each pixel, where the pinhole saw `seen` of the same mesh: the rays that no
/// displacement reaches are not cast.
template <DistortedPinhole C>
FragmentImage raycast(const C& camera, const FragmentImage& seen, const Mesh& mesh, const RayScene& scene) {
  FragmentImage fragments = raycast(camera, mesh, scene, unreachedPart(camera, seen));
  keepUndisplaced(camera, seen, fragments);
  return fragments;
}

}  // namespace ocelli
