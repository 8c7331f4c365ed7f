// Rays of a chosen camera, as they are drawn.
#pragma once

#include <vector>

#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// The part of a ray between two depths along the view direction of `reference`; empty where there is none.
std::vector<glm::vec3> rayBetween(const RayPath& ray, const PinholeCamera& reference, float nearest, float farthest);

/// Whether the ray departs from the straight line between its ends by more than `tolerance`, world units.
bool isBent(const std::vector<glm::vec3>& ray, float tolerance);

}  // namespace ocelli
