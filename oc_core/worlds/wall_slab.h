// Flat slabs with rectangular openings: walls with doors and windows, window frames, roofs, pavements.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Cells between the lines at `xs` and `ys` (ascending, two or more each), from z = -thickness, the back, to z = 0, the
/// front. The functions take a cell (i, j) as addPanel() does.
struct WallSlab {
  std::vector<float> xs;
  std::vector<float> ys;
  float thickness = 1;
  std::function<glm::vec3(size_t i, size_t j)> color;  ///< linear, of the front and the sides
  glm::vec3 back{1};
  /// Nothing for no openings. Openings may touch along edges, not at corners alone.
  std::function<bool(size_t i, size_t j)> isOpen;
};

/// Adds a closed solid; every cell has vertices of its own, so colours are crisp. `worldFromSlab` must not mirror.
void addSlab(Mesh& mesh, const WallSlab& slab, const glm::mat4& worldFromSlab);

}  // namespace ocelli
