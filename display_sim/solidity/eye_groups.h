// Eyes that something is measured from, in groups whose figures are given together.
#pragma once

#include <string>
#include <vector>

#include "oc_core/ocri/view_cell.h"

namespace ocelli {

struct EyeGroup {
  std::string name;
  std::vector<glm::vec3> eyes;  ///< in display radii
};

/// "reference", "edges" and, where there are any, "interior": the viewpoints of `ocelli evaluate`.
std::vector<EyeGroup> eyesOfCell(const View& reference, const ViewCell& cell, int interiorViews, unsigned seed);

}  // namespace ocelli
