#include "analysis/measures/walk.h"

#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSideOfObject = 0.8;

}  // namespace

std::optional<WalkMeasures> measureWalk(std::span<const Pose> poses) {
  if (poses.size() < 2 || poses.back().tick <= poses.front().tick) {
    return std::nullopt;
  }
  WalkMeasures walk;
  for (size_t i = 1; i < poses.size(); ++i) {
    const Pose& before = poses[i - 1];
    const Pose& pose = poses[i];
    const double seconds = static_cast<double>(pose.tick - before.tick) / kPoseTicksPerSecond;
    const double meters = std::hypot(pose.x - before.x, pose.z - before.z);
    const double radians = std::abs(std::remainder(pose.heading - before.heading, 2 * kPi));
    const bool stands = meters < kStandingMetersPerSecond * seconds || meters == 0;
    const bool turns = radians > kNotTurningDegreesPerSecond * kPi / 180 * seconds && radians > 0;
    walk.seconds += seconds;
    walk.pathMeters += meters;
    walk.turnedRadians += radians;
    walk.standing += stands ? seconds : 0;
    walk.turning += turns ? seconds : 0;
    walk.still += stands && !turns ? seconds : 0;
  }
  walk.standing /= walk.seconds;
  walk.turning /= walk.seconds;
  walk.still /= walk.seconds;
  return walk;
}

bool isInSight(const MazeFloor& floor, const Pose& pose, const TargetObject& object, double fovHorizontalDegrees) {
  const FloorPoint eye{pose.x, pose.z};
  const double dx = object.place.x - eye.x;
  const double dz = object.place.z - eye.z;
  const double distance = std::hypot(dx, dz);
  if (distance == 0) {
    return true;
  }
  for (const double side : {0.0, -kSideOfObject, kSideOfObject}) {
    const double offset = side * object.radius / distance;
    const FloorPoint point{object.place.x - offset * dz, object.place.z + offset * dx};
    const double direction = std::atan2(point.x - eye.x, -(point.z - eye.z));
    const double angle = std::abs(std::remainder(direction - pose.heading, 2 * kPi));
    if (angle <= fovHorizontalDegrees / 2 * kPi / 180 && floor.isClear(eye, point)) {
      return true;
    }
  }
  return false;
}

std::optional<double> firstInSight(const MazeFloor& floor, std::span<const Pose> poses, const TargetObject& object,
                                   double fovHorizontalDegrees) {
  for (const Pose& pose : poses) {
    if (isInSight(floor, pose, object, fovHorizontalDegrees)) {
      return static_cast<double>(pose.tick) / kPoseTicksPerSecond;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
