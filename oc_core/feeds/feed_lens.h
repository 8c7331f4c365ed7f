// The lens of a video camera: what turns the image of an ideal pinhole into the camera's, after Brown and Conrady, with
// the coefficients in the order and meaning of OpenCV's calibration (k1, k2, p1, p2, k3).
//
// (x, y) is a direction as a pinhole of focal length 1 sees it: x to the right, y down. With r2 = x^2 + y^2
//
//   radial = 1 + k1 r2 + k2 r2^2 + k3 r2^3
//   x' = x radial + 2 p1 x y + p2 (r2 + 2 x^2)
//   y' = y radial + p1 (r2 + 2 y^2) + 2 p2 x y
//   pixel = focal (x', y') + center
//
// Pixels are measured from the top left corner of the image; the middle of the first one is (0.5, 0.5). OpenCV
// measures from that middle: its center is less by 0.5.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

namespace ocelli {

struct FeedLens {
  glm::dvec2 focal{1};   ///< pixels
  glm::dvec2 center{0};  ///< pixels
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;

  bool operator==(const FeedLens&) const = default;
};

/// The pixel of a direction (x, y). Nothing where the polynomial has turned back, so far out that the lens says nothing
/// of it.
std::optional<glm::dvec2> pixelOf(const FeedLens& lens, const glm::dvec2& direction);

/// The direction of a pixel, by Newton's method, to 1e-9; nothing where none has that image.
std::optional<glm::dvec2> directionOf(const FeedLens& lens, const glm::dvec2& pixel);

}  // namespace ocelli
