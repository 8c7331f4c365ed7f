// What a feed sees of the floor, for plans.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

/// How far a footprint reaches from its camera, at most: metres.
inline constexpr double kMaxFootprint = 12;

/// The outline of the floor that a feed shows, (x, z): where the rays of its upper border meet it, from the left, and
/// then those of its lower border, from the right. Rays that meet it farther off, or not at all, end at kMaxFootprint.
std::vector<glm::dvec2> footprintOf(const FeedSetup& setup, size_t feed);

}  // namespace ocelli
