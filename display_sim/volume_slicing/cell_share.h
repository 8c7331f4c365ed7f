// How much of a cell of the sweep lies on one side of a plane: of a block with three pairs of parallel faces, which a
// cell nearly is.
#pragma once

#include <glm/vec3.hpp>

namespace ocelli {

/// The share of the block's volume on the inner side of a plane, exactly. `distance` is that of the block's centre from
/// the plane, positive on the inner side, and `reaches` how far each half edge reaches along the plane's normal, at
/// least 0. In any unit.
double shareOfBlock(double distance, const glm::dvec3& reaches);

}  // namespace ocelli
