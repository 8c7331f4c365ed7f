// Edits the regions of a general pinhole camera by hand, as lenses (focus plus context, section 5.2.2): whatever is
// wanted, the layout stays valid. A lens that is moved or sized stops where its transition touches a neighbour's, or
// the border of the image, and slides along it: of all valid places it gets the one that is nearest to the wanted one,
// in pixels. So where a lens comes to lie depends on where it is wanted, not on the way there: beyond the middle of a
// neighbour, the nearest place is on its other side.
//
// Lengths and places are shares of the image, as in GpcRegion; `size` is that of the image, pixels. All functions take
// a layout that is valid, and an index of one of its regions.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/camera/gpc_layout.h"
#include "oc_core/camera/gpc_lens_room.h"

namespace ocelli {

/// What a lens takes up with its transition.
LensBox lensBox(const GpcRegion& lens);
LensBox lensInnerBox(const GpcRegion& lens);

/// No lens becomes smaller by hand, along either axis, unless it is so already.
inline constexpr double kMinLensExtent = 0.01;

/// The centre goes as near to `wanted` as it can.
void moveLens(GpcLayout& layout, size_t lens, const glm::dvec2& wanted, const glm::dvec2& size);

/// The corners of the region itself, without its transition.
enum class LensCorner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };
glm::dvec2 cornerOf(const GpcRegion& lens, LensCorner corner);
/// One corner goes as near to `wanted` as it can; the opposite one stays. It does not go past that.
void dragLensCorner(GpcLayout& layout, size_t lens, LensCorner corner, const glm::dvec2& wanted,
                    const glm::dvec2& size);
/// Width and height become those that are nearest to `wanted`; the centre stays.
void sizeLens(GpcLayout& layout, size_t lens, const glm::dvec2& wanted, const glm::dvec2& size);

/// The nearest zoom that does not fold.
void zoomLens(GpcLayout& layout, size_t lens, double wanted);
/// The nearest transition width for which there is room, and which does not fold.
void widenLens(GpcLayout& layout, size_t lens, double wanted);
/// For all of them. Zooms below 1 that would fold grow as little as they must.
void setLensSampling(GpcLayout& layout, const GpcSampling& sampling);

/// Adds a lens that shows `wanted.center` in its inner rectangle, as near to the middle as there is room: as wanted, or
/// a half, a quarter or an eighth as wide and high. Its index; nothing where there is no room, or there are
/// GpcLayout::kMaxRegions already.
std::optional<size_t> addLens(GpcLayout& layout, const GpcRegion& wanted, const glm::dvec2& size);
void removeLens(GpcLayout& layout, size_t lens);

}  // namespace ocelli
