#include "display_sim/viewer/colored_line.h"

#include <cstddef>

namespace ocelli {

void addPolyline(std::vector<ColoredLine>& lines, const std::vector<glm::vec3>& points, const glm::vec4& color,
                 float widthPixels) {
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    lines.push_back({points[i], points[i + 1], color, widthPixels});
  }
}

void addBoxEdges(std::vector<ColoredLine>& lines, const std::vector<glm::vec3>& corners, const glm::vec4& color,
                 float widthPixels) {
  for (size_t corner = 0; corner < 8; ++corner) {
    for (size_t bit = 1; bit <= 4; bit *= 2) {
      if ((corner & bit) == 0) {
        lines.push_back({corners[corner], corners[corner | bit], color, widthPixels});
      }
    }
  }
}

}  // namespace ocelli
