// Lines in space, to be drawn.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace ocelli {

struct ColoredLine {
  glm::vec3 from{0};
  glm::vec3 to{0};
  glm::vec4 color{1};  ///< sRGB, opacity
  float widthPixels = 1;
};

/// Adds the segments of a polyline.
void addPolyline(std::vector<ColoredLine>& lines, const std::vector<glm::vec3>& points, const glm::vec4& color,
                 float widthPixels);
/// Adds the twelve edges of a box with these corners: bit 0 of an index is x, bit 1 y, bit 2 z.
void addBoxEdges(std::vector<ColoredLine>& lines, const std::vector<glm::vec3>& corners, const glm::vec4& color,
                 float widthPixels);

}  // namespace ocelli
