// What it takes to find where a ray meets a reference image.
#pragma once

#include <cstddef>

namespace ocelli {

struct RayCost {
  size_t nodes = 0;      ///< of the pyramid, whose children were looked at: up to 16 boxes each
  size_t cells = 0;      ///< of samples, whose triangles were tested
  size_t boxes = 0;      ///< children of those nodes
  size_t triangles = 0;  ///< of those cells

  /// Places of the image that were looked at, as the text counts them.
  size_t steps() const { return nodes + cells; }
  RayCost& operator+=(const RayCost& other) {
    nodes += other.nodes;
    cells += other.cells;
    boxes += other.boxes;
    triangles += other.triangles;
    return *this;
  }
};

}  // namespace ocelli
