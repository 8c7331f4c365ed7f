// Regions that are wanted in an image of a general pinhole, and how they become valid ones: within the image, and
// disjoint with their transitions (gpc_layout.h).
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/camera/gpc_layout.h"

namespace ocelli {

/// A rectangle of the pinhole's image that is to be sampled more densely.
struct RegionWish {
  glm::dvec2 center{0.5};   ///< shares of the image
  glm::dvec2 content{0.5};  ///< its width and height in the pinhole's image, the same shares
  double zoom = 2;          ///< samples for each one of the pinhole
  double transition = 1;    ///< as GpcRegion::transitionWidth; less where there is no room
};

/// Wishes for a zoom of at most 1 are left out: the image has that. What reaches over a border shows less. Of two
/// that overlap, with transitions as narrow as can be, one region is made that shows all of both, with the higher of
/// the zooms, or as much of it as there is room for. Then transitions get as wide as is wished and there is room.
std::vector<GpcRegion> regionsOf(std::vector<RegionWish> wishes);

/// The same, and a region that gives way to all others: it gets smaller around its centre until it overlaps none; where
/// less than half of it is left, it is left out.
std::vector<GpcRegion> regionsOf(std::vector<RegionWish> wishes, const RegionWish& yielding);

}  // namespace ocelli
