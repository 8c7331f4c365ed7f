// Where a camera stands, from points of the world and their pixels: SQPnP (Terzakis and Lourakis 2020) by OpenCV,
// refined to the least sum of squared pixel distances by Levenberg and Marquardt.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

/// Three points have up to four poses; the fourth decides.
inline constexpr size_t kMinPosePoints = 4;
/// With a focal length to be found, too.
inline constexpr size_t kMinPosePointsWithoutLens = 6;

struct WorldPoint {
  glm::dvec2 pixel{0};  ///< from the top left corner of the image
  glm::dvec3 point{0};  ///< metres, y up
};

struct SolvedPose {
  FeedPose pose;
  FeedLens lens;  ///< as given, or with the focal length that was found
  double rmsPixels = 0;
  double maxPixels = 0;
  size_t worst = 0;  ///< the point of maxPixels
};

/// Where a point of the world is seen; nothing behind the camera or where the lens says nothing of it.
std::optional<glm::dvec2> pixelOfPoint(const FeedLens& lens, const FeedPose& pose, const glm::dvec3& point);

/// Throws InputError, naming `where`, for fewer points than kMinPosePoints, for points in one line, and for a table
/// that is mirrored: whose points fit much better with x turned around.
SolvedPose solvePose(const std::vector<WorldPoint>& points, const FeedLens& lens, const std::string& where);

/// The same without a lens: one focal length, no distortion, the center of the image. Throws for fewer points than
/// kMinPosePointsWithoutLens, and where they are all in one plane.
SolvedPose solvePoseAndFocal(const std::vector<WorldPoint>& points, int width, int height, const std::string& where);

}  // namespace ocelli
