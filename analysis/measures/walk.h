// What a walk tells by itself: how far, how much one turned, when one stood.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "oc_core/maze/maze_floor.h"

namespace ocelli {

/// A row of `frame`.
struct Pose {
  int64_t tick = 0;  ///< of the trial, 1/240 s
  double x = 0;
  double z = 0;
  double heading = 0;  ///< radians, clockwise from north, seen from above
};
inline constexpr double kPoseTicksPerSecond = 240;

struct WalkMeasures {
  double seconds = 0;        ///< from the first pose to the last
  double pathMeters = 0;     ///< along the poses, frame by frame
  double turnedRadians = 0;  ///< all turns, either way; between two frames the shorter way
  // Shares of the time, 0 to 1.
  double standing = 0;  ///< not going from the place, turning or not
  double turning = 0;   ///< turning, going or not
  double still = 0;     ///< neither
};

/// Slower is standing, and not turning: less than a tenth of a slow walk, and what a hand's tremor on a mouse does.
inline constexpr double kStandingMetersPerSecond = 0.05;
inline constexpr double kNotTurningDegreesPerSecond = 1;

/// Nothing for fewer than two poses, or where no time passes. Poses are in the order of their ticks.
std::optional<WalkMeasures> measureWalk(std::span<const Pose> poses);

/// What is looked for.
struct TargetObject {
  FloorPoint place;
  double radius = 0;  ///< metres
};

/// Whether the object stands in the straight sight of a pinhole at the pose: within its horizontal field of view, and
/// with the middle or either side (at four fifths of the radius) not hidden by walls. Walls are higher than eyes and
/// objects, so heights do not matter.
bool isInSight(const MazeFloor& floor, const Pose& pose, const TargetObject& object, double fovHorizontalDegrees);

/// Seconds from the start of the trial to the first pose that has the object in sight.
std::optional<double> firstInSight(const MazeFloor& floor, std::span<const Pose> poses, const TargetObject& object,
                                   double fovHorizontalDegrees);

}  // namespace ocelli
