// The rays of a chosen camera, to be drawn: those that its reference images were sampled along.
#pragma once

#include <functional>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

/// The ray of a pixel of one reference image; empty where it has none.
using RayFunction = std::function<RayPath(const glm::vec2& pixel)>;

/// One function for each of the images that buildReferenceImages() makes of this choice, in their order. Builds the
/// cameras, so it takes about as long, and throws as it does.
std::vector<RayFunction> cameraRays(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                    const ReferenceImages& images, const Progress& progress = {});

/// The part of a ray between two depths along the view direction of `reference`; empty where there is none.
std::vector<glm::vec3> rayBetween(const RayPath& ray, const PinholeCamera& reference, float nearest, float farthest);

/// Whether the ray departs from the straight line between its ends by more than `tolerance`, world units.
bool isBent(const std::vector<glm::vec3>& ray, float tolerance);

}  // namespace ocelli
