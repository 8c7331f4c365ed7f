// What a click on the picture means: the ray of its pixel, bend after bend, to what it meets.
#pragma once

#include <optional>
#include <vector>

#include "oc_core/explore/explore_frame.h"
#include "oc_core/explore/explore_scene.h"
#include "oc_core/explore/live_constructor.h"

namespace ocelli {

/// All openings that are known, each seen from both of its sides where both are open: those of the scene, or else of
/// its maze, or else of its ways.
std::vector<Portal> knownPortals(const ExploreScene& scene);

/// Nothing for a pixel outside of the picture, and for a ray that meets neither a surface nor an opening.
std::optional<ExplorePick> pickAt(const ExploreScene& scene, const ExploreFrame& frame, const glm::dvec2& pixel);

}  // namespace ocelli
