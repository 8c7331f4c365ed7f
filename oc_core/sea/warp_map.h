// Where one image of a sea shows what another one sees: image warping over the proxy (section 3.5.4.2.2), backwards, so
// that every pixel of the target asks one place of the reference.
//
// DEVIATION: the text projects features of the proxy into both images, and warps triangles between them; here rays of
// the target are cast at the proxy on a grid, which is refined where the proxy bends or ends. That needs no graphics
// hardware, and knows exactly what the reference does not see.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec2.hpp>

#include "oc_core/image/image.h"
#include "oc_core/sea/sea_projection.h"
#include "oc_core/sea/sea_proxy.h"

namespace ocelli {

/// Of each pixel of the target, the pixel of the reference, which may lie beyond the borders of an image that wraps;
/// NaN where the reference does not see what the target sees.
using WarpMap = Image<glm::vec2>;

inline bool isSeen(const glm::vec2& place) {
  return !std::isnan(place.x);
}

/// Of the distance from the reference: nearer than that to a point, what its ray meets is the point.
inline constexpr float kSightMargin = 2e-3f;

/// The pixels between the rays that are cast first. More makes maps faster, and misses thin things.
inline constexpr int kWarpCell = 16;

/// On the calling thread alone.
WarpMap makeWarpMap(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference, int cell = kWarpCell);

/// The same strip by strip, from the top down: what is drawn of one strip need not wait for the memory of the others.
/// `strip` has the rows from `top` on, as many as the cell has pixels, but for the last one.
void forEachWarpStrip(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference, int cell,
                      const std::function<void(int top, const WarpMap& strip)>& visit);

/// The same with rays for every pixel: slow, and what the one above is compared with.
WarpMap exactWarpMap(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference);

}  // namespace ocelli
