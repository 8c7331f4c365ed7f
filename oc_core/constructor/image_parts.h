// Convex parts of an image: the image of a flat polygon, and what parts have in common or not.
#pragma once

#include <span>
#include <vector>

#include "oc_core/camera/graph_camera.h"

namespace ocelli {

/// What a pinhole sees of a convex flat polygon between zNear and zFar and within the image, clockwise as seen. Empty
/// where that is less than a thousandth of a square pixel. No two corners coincide.
GraphCamera::Part imagePart(std::span<const glm::dvec3> corners, const PinholeCamera& camera);

/// Square pixels of a part; negative for one that runs counter-clockwise as seen.
double areaOf(const GraphCamera::Part& part);

/// What two convex parts share; empty as above.
GraphCamera::Part common(const GraphCamera::Part& part, const GraphCamera::Part& other);

/// `part` less `other`, in convex pieces; those that would be empty as above are left out.
std::vector<GraphCamera::Part> less(const GraphCamera::Part& part, const GraphCamera::Part& other);

}  // namespace ocelli
