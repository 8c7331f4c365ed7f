// Depth peeling in one pass: at each pixel of a planar pinhole camera the `layers` closest fragments instead of the
// closest one. Fill rule and depths are those of rasterize() (visibility_buffer.h), so the first layer of a mesh
// without culled triangles is its image.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/fragment_image.h"

namespace ocelli {

inline constexpr int kMaxLayers = 16;

/// Which sides of a triangle are drawn. The front is the side from which its vertices run counter-clockwise.
enum class DrawnSides : uint8_t { kBoth, kFront, kBack };

/// One image a layer, the closest first; layers that nothing reaches are empty. Fragments of equal depth count once: of
/// surfaces that coincide the one with the lower triangle index stays. `sides` holds one entry a triangle, or none
/// where both sides of all are drawn. 1 to kMaxLayers layers.
std::vector<FragmentImage> rasterizeLayers(const PinholeCamera& camera, const Mesh& mesh, int layers,
                                           const std::vector<DrawnSides>& sides = {});

}  // namespace ocelli
