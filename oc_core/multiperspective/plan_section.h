// Where a plane cuts a scene: the walls of a floor plan.
#pragma once

#include <array>
#include <vector>

#include "oc_core/multiperspective/plan_side.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// A straight piece of the cut, on the paper.
using SectionLine = std::array<glm::vec2, 2>;

/// What the plane across the axis of `side` at coordinate `at` cuts. Triangles with coordinates that are no numbers,
/// and those that lie in the plane, give nothing.
std::vector<SectionLine> sectionOf(const Mesh& mesh, PlanSide side, float at);

}  // namespace ocelli
