// Rigs of one camera each, made from a seed: a lens, views of a board, and a room with tags, through the whole
// calibration; and how far what comes out is from the truth.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds/known_places.h"
#include "tests/feeds_calibration/rendered_sheet.h"

namespace ocelli::test {

struct CalibrationRig {
  int width = 640;
  int height = 480;
  FeedLens lens;
  FeedPose pose;
  KnownPlaces places;  ///< tags on three walls of a room of 6 x 2.8 x 9 m
  PictureNoise noise;
};

/// Focal length 0.7 to 1.5 widths, barrel distortion, blur of 0.4 to 0.9 pixels, noise of 1 to 4 levels.
CalibrationRig calibrationRig(uint64_t seed);

/// Views of a board over all of the image, tilted by 10 to 40 degrees.
std::vector<Image<Rgb8>> boardPictures(const CalibrationRig& rig, const CalibrationBoard& board, size_t count,
                                       RandomNumbers& random);
Image<Rgb8> tagPicture(const CalibrationRig& rig, RandomNumbers& random);

/// The points of the room that a grid of 16 by 12 pixels sees.
std::vector<glm::dvec3> seenPoints(const CalibrationRig& rig);

struct RigErrors {
  double lensRms = 0;
  double poseRms = 0;
  double meanPixels = 0;  ///< between where the true camera and the calibrated one see points of the room
  double worstPixels = 0;
  size_t tags = 0;
};

/// Calibrates lens and pose from pictures, as `ocelli feeds calibrate` does, and compares.
RigErrors calibratedErrors(uint64_t seed);

}  // namespace ocelli::test
