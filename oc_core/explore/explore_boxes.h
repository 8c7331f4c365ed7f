// Boxes that someone clicks, to look around them or to keep them in sight, and how a camera that bends at one fades out
// where it comes too near or leaves the image.
#pragma once

#include <optional>

#include "oc_core/explore/explore_scene.h"
#include "oc_core/explore/live_constructor.h"

namespace ocelli {

/// The box of the object that was clicked; a box of half a metre around the place where it is structure. Nothing where
/// no surface was met.
std::optional<Box> clickedBox(const ExploreScene& scene, const ExplorePick& pick);

/// From 0 to 1, steady in the view: 0 where the nearest corner is less than `from` metres before the eye, 1 from `to`
/// on.
double fadedByDepth(const Box& box, const PinholeCamera& view, double metre, double from, double to);
/// 0 where the middle is not in the image, 1 where it is well within.
double fadedByBorder(const Box& box, const PinholeCamera& view);

}  // namespace ocelli
