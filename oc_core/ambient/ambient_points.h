// The points of a view at which ambient light is measured: what its pixels show.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

struct AmbientPoint {
  glm::vec3 position{0};  ///< in the world
  glm::vec3 normal{0};    ///< unit, of the triangle; towards the eye
  float footprint = 0;    ///< of the view's pixel there: z / focal length in pixels, world units
  uint32_t pixel = 0;     ///< its index in the image
  uint32_t triangle = 0;  ///< of the mesh
};

/// By pixel; none where a pixel shows no surface, a triangle without an area, or one that `receives` does not take
/// (all where it is empty). A surface that is seen edge-on keeps its normal, turned to the side that the eye is on.
std::vector<AmbientPoint> ambientPoints(const PinholeCamera& camera, const FragmentImage& seen, const Mesh& mesh,
                                        const std::function<bool(uint32_t triangle)>& receives = {});

}  // namespace ocelli
