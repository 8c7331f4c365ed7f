// A graphical fisheye at each focus: the polar transformation of
//   M. Sarkar and M. H. Brown: Graphical fisheye views. Communications of the ACM 37 (12), 1994.
// A place at distance x from the middle is shown at distance g(x) = (d + 1) x / (d x + 1) on the same line, both as
// shares of the distance to the border, where g(1) = 1. The border is the ellipse within the rectangle that a general
// pinhole's lens takes up with its transition, so that both distort the same part of the image, and several have room.
//
// The text of 1994 has one focus, and its border is that of the whole image. d is chosen so that what is in focus is
// as large as in the other ways: along the axes g takes the edge of the focus to the edge of the region. The zoom at
// the middle is then d + 1, greater than that of the lens, and falls outward: a fisheye has no other way to a focus of
// the same mean zoom.
#pragma once

#include "oc_core/focus/focus_map.h"

namespace ocelli {

/// d, for which g takes 1 / (zoom outer) to 1 / outer.
double fisheyeDistortion(double zoom, double outer);

std::unique_ptr<FocusMap> fisheyeFocusMap(const GpcLayout& layout, const glm::ivec2& size);

}  // namespace ocelli
