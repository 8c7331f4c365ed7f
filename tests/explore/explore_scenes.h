// Small scenes to walk in, in metres, made by hand.
#pragma once

#include "oc_core/explore/explorer.h"

namespace ocelli::test {

/// Seconds from frame to frame.
inline constexpr double kExploreFrame = 1.0 / 30;

/// Pictures of 160 x 90 pixels.
ExplorerOptions smallPictures();

/// An axis-aligned box of that object and colour.
void addBox(GuidedScene& scene, const Box& box, uint32_t object, const glm::vec3& color);

/// A floor from -10 to 10 in checks, at y = 0, with walls of 3 m around it.
GuidedScene hall();

/// The hall with a thin wall across it at z = -3, with a door of 1 x 2 m in its middle, which is a portal; behind it
/// stands a red box, object 1, to the left, and a green one, object 2, to the right.
GuidedScene twoRooms();

/// The hall with a narrow box, object 1, at z = -4, and a red box, object 2, right behind it, at z = -7.
GuidedScene hiddenBox();

/// The hall with a path that turns twice.
GuidedScene hallWithPath();

}  // namespace ocelli::test
