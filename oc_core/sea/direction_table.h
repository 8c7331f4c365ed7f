// The directions of a grid of places in an image, as SeaProjection::direction() has them: made once, for many images.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/sea/sea_projection.h"

namespace ocelli {

class DirectionTable {
 public:
  /// Places are at `first + i * step` pixels in both directions: so many columns and rows of them.
  struct Grid {
    int columns;
    int rows;
    float first;
    float step;
  };

  DirectionTable(const SeaProjection& projection, const Grid& grid);

  glm::vec3 operator()(int column, int row) const {
    if (longitudes_.empty()) {
      return projection_.direction(glm::vec2(column, row) * grid_.step + grid_.first);
    }
    const glm::vec2& longitude = longitudes_[static_cast<size_t>(column)];
    const glm::vec2& latitude = latitudes_[static_cast<size_t>(row)];
    return {longitude.x * latitude.x, latitude.y, longitude.y * latitude.x};
  }

 private:
  SeaProjection projection_;
  Grid grid_;
  std::vector<glm::vec2> longitudes_;  ///< of a panorama: x and z of level directions
  std::vector<glm::vec2> latitudes_;   ///< how long their level part is, and their y
};

}  // namespace ocelli
