// Corners between squares to a small part of a pixel, from long pieces of the edges that meet there.
//
// Foerstner and Guelch 1987, "A fast operator for detection and precise location of distinct points": where edges meet
// at q, each gradient g at a place p beside q is across the line from p to q, g . (q - p) = 0; q is where the sum of
// squares is least. OpenCV's cornerSubPix() solves the same over a square window, which must be small enough that no
// marker reaches into it; here the window is a cross along both edges, which may be as long as the squares.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/image/image.h"

namespace ocelli {

struct CornerCross {
  glm::dvec2 corner{0};        ///< about where, from the middle of the first pixel
  glm::dvec2 alongRows{1, 0};  ///< of both edges, in pixels: unit vectors
  glm::dvec2 alongColumns{0, 1};
  double reach = 5;      ///< pixels along each edge
  double halfWidth = 2;  ///< pixels beside each
};

/// The corner, from the middle of the first pixel; as it was given where it would move by more than `halfWidth`, or
/// where the cross leaves the image.
glm::dvec2 refinedCorner(const Image<float>& gray, const CornerCross& cross);

}  // namespace ocelli
