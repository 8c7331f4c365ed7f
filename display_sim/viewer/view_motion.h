// Moving a view by hand: around its target, along its image plane, and nearer to its target or away from it.
#pragma once

#include "oc_core/camera/view.h"

namespace ocelli {

/// A hand-moved eye keeps such a distance from its target.
inline constexpr float kMinViewDistance = 0.05f;
inline constexpr float kMaxViewDistance = 500;
/// Nor is its target moved farther than this from the origin.
inline constexpr float kFarthestTarget = 1000;

/// The eye turned around the target: to the right around "up", then upwards, short of the poles. Angles in radians. The
/// field of view stays as it is, here and below: one that was given as "just holds the unit sphere" gets its value.
View orbited(const View& view, double right, double up);

/// Eye and target moved along the image plane, in image heights at the depth of the target.
View panned(const View& view, double right, double up);

/// The eye's distance from the target times `factor`, within the limits above.
View zoomed(const View& view, double factor);

}  // namespace ocelli
