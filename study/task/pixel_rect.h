// A rectangle of the screen, in pixels, origin at the top left.
#pragma once

#include <glm/vec2.hpp>

namespace ocelli {

struct PixelRect {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  glm::dvec2 center() const { return {left + width / 2, top + height / 2}; }
  bool contains(const glm::dvec2& point) const {
    return point.x >= left && point.x < right() && point.y >= top && point.y < bottom();
  }
  bool operator==(const PixelRect&) const = default;
};

}  // namespace ocelli
