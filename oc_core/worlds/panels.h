// Patterned flat panels whose vertex colours carry a crisp pattern: each cell of the pattern has vertices of its own,
// and all cells lie on one grid of lines, so that neighbours share whole edges and no crack opens between them.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Adds the cells between the lines at `xs` and `ys` (ascending, at least two each) of the plane that `worldFromPanel`
/// makes of z = 0; its front is the side of +z. `color(i, j)` is the linear colour of the cell between lines i and i +
/// 1 in x, j and j + 1 in y.
void addPanel(Mesh& mesh, const std::vector<float>& xs, const std::vector<float>& ys, const glm::mat4& worldFromPanel,
              const std::function<glm::vec3(size_t i, size_t j)>& color);

/// `count` + 1 lines from `first` to `last`.
std::vector<float> evenLines(float first, float last, size_t count);

/// A vertical wall of bricks in the plane z = `z`, facing +z.
void addBrickWall(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float z, size_t rows, size_t bricksInRow);

/// A horizontal floor of square-ish tiles in two alternating colours in the plane y = `y`, facing +y; corners in (x,
/// z).
void addCheckerFloor(Mesh& mesh, const glm::vec2& lower, const glm::vec2& upper, float y, size_t columns, size_t rows,
                     const glm::vec3& dark, const glm::vec3& light);

}  // namespace ocelli
