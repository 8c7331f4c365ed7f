// Antialiasing of any camera, and the reference for all other ways: several rays a pixel, cast along the paths of the
// camera, and the average of what they meet.
#pragma once

#include <functional>

#include "oc_core/antialiasing/sample_positions.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

/// Linear colours. `rayPath` takes any point of the image; an empty path sees the background. On all threads.
Image<glm::vec3> raySampledImage(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                                 const RayScene& scene, const SamplePattern& pattern, const glm::vec3& background);

}  // namespace ocelli
