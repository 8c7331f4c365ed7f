#include "oc_core/sea/direction_table.h"

namespace ocelli {

DirectionTable::DirectionTable(const SeaProjection& projection, const Grid& grid)
    : projection_(projection), grid_(grid) {
  if (projection.kind != SeaProjectionKind::kPanorama) {
    return;
  }
  const glm::vec2 middle = 0.5f * glm::vec2(projection.width, projection.height);
  const auto place = [&](int i) { return grid.first + static_cast<float>(i) * grid.step; };
  for (int column = 0; column < grid.columns; ++column) {
    const glm::vec3 level = projection.direction({place(column), middle.y});
    longitudes_.emplace_back(level.x, level.z);
  }
  for (int row = 0; row < grid.rows; ++row) {
    const glm::vec3 ahead = projection.direction({middle.x, place(row)});
    latitudes_.emplace_back(-ahead.z, ahead.y);
  }
}

}  // namespace ocelli
