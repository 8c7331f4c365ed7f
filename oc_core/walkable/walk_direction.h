// The direction in which most walls of a scene stand.
#pragma once

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The angle by which walls are turned about the vertical, from the x axis towards -z: radians, in [0, pi / 2). Each
/// steep triangle counts by its area; walls at right angles count as one direction. 0 where there are none.
double wallDirection(const Mesh& mesh);

/// The same mesh without colours, turned by that angle about the vertical axis: from the x axis towards -z.
Mesh turnedAboutVertical(const Mesh& mesh, double angle);

}  // namespace ocelli
