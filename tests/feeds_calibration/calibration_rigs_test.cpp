// The goal of calibration: within half a pixel over 100 simulated rigs (thorough), and over the first two of them here.
#include "tests/feeds_calibration/calibration_rigs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace ocelli::test {
namespace {

/// The goal of graph cameras from video: the mean error over a feed's image.
constexpr double kGoalPixels = 0.5;

void checkRigs(uint64_t rigs) {
  double worstMean = 0;
  double sum = 0;
  double worst = 0;
  for (uint64_t seed = 1; seed <= rigs; ++seed) {
    const RigErrors errors = calibratedErrors(seed);
    fmt::print("rig {:3}: lens {:.3f} pose {:.3f} pixels RMS, {} tags; mean {:.3f} worst {:.3f}\n", seed,
               errors.lensRms, errors.poseRms, errors.tags, errors.meanPixels, errors.worstPixels);
    EXPECT_LT(errors.meanPixels, kGoalPixels) << "rig " << seed;
    worstMean = std::max(worstMean, errors.meanPixels);
    worst = std::max(worst, errors.worstPixels);
    sum += errors.meanPixels;
  }
  fmt::print("{} rigs: mean {:.3f}, worst rig {:.3f}, worst point {:.3f} pixels\n", rigs,
             sum / static_cast<double>(rigs), worstMean, worst);
}

TEST(CalibrationRigs, aFewAreCalibratedToWithinHalfAPixel) {
  checkRigs(2);
}

TEST(ThoroughCalibrationRigs, aHundredAreCalibratedToWithinHalfAPixel) {
  checkRigs(100);
}

}  // namespace
}  // namespace ocelli::test
