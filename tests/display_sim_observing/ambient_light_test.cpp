#include "display_sim/observing/ambient_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

constexpr int kSide = 200;

// A level ray that passes the axis at the distance b meets the cylinder over the angle 2 acos(b).
TEST(AmbientLight, coverageIsTheAngleThatTheRayCovers) {
  const DisplayProfile profile = test::smallProfile(40, 64, 64);
  const ObserverOptions options{.width = kSide, .height = kSide};
  const double pixelsPerTangent = kSide / 2.0 / std::tan(std::asin(0.1));
  for (const double b : {0.0, 0.3, -0.7, 0.99}) {
    const double u = kSide / 2.0 + pixelsPerTangent * std::tan(std::asin(b / 10));
    EXPECT_NEAR(screenCoverage(options, profile, u, kSide / 2.0), 2 * std::acos(std::abs(b)) / kPi, 1e-6) << b;
  }
  EXPECT_EQ(screenCoverage(options, profile, -1, kSide / 2.0), 0);
  EXPECT_EQ(screenCoverage(options, profile, kSide / 2.0, -30), 0) << "above the screen";
}

// All voxels white, seen by each pixel where the screen is there: that is what 1 stands for. Voxels of slices that are
// seen from their edge are boxes that stand for arcs, so that single pixels ripple by some hundredths.
TEST(AmbientLight, isThatOfAWhiteScreen) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const DisplayProfile profile = test::smallProfile(60, 48, 48, half);
    Volume white(profile);
    for (int slice = 0; slice < white.slices(); ++slice) {
      for (int row = 0; row < white.height(); ++row) {
        for (int column = 0; column < white.width(); ++column) {
          white.light(slice, column, row, kAllChannels);
        }
      }
    }
    for (const glm::vec3& eye : {glm::vec3(0, 0, 10), glm::vec3(3, 5, 4)}) {
      ObserverOptions options{
          .eye = eye, .width = kSide, .height = kSide, .emission = {.model = EmissionModel::kScreen}};
      const Image<glm::vec3> seen = collectLight(white, options);
      options.ambient = 1;
      const Image<glm::vec3> veil = collectLight(Volume(profile), options);
      EXPECT_NEAR(test::middleOf(seen, 60) / test::middleOf(veil, 60), 1, 0.01);
      EXPECT_NEAR(test::sumOf(seen).x / test::sumOf(veil).x, 1, 0.01);
    }
  }
}

TEST(AmbientLight, growsWithTheExposureAndLiesOnTop) {
  const DisplayProfile profile = test::smallProfile(40, 32, 32);
  Volume volume(profile);
  volume.light(3, 20, 20, kAllChannels);
  ObserverOptions options{.width = 60, .height = 60, .exposureSeconds = 3.0 / 24};
  const Image<glm::vec3> alone = collectLight(volume, options);
  options.ambient = 0.01;
  const Image<glm::vec3> both = collectLight(volume, options);
  const Image<glm::vec3> veil = collectLight(Volume(profile), options);
  options.exposureSeconds = 1.0 / 24;
  const Image<glm::vec3> shorter = collectLight(Volume(profile), options);
  for (size_t i = 0; i < both.size(); ++i) {
    EXPECT_FLOAT_EQ(both[i].y, alone[i].y + veil[i].y);
    EXPECT_NEAR(veil[i].y, 3 * shorter[i].y, 1e-5f * veil[i].y);
  }
  EXPECT_GT(veil(30, 30).x, 0);
}

}  // namespace
}  // namespace ocelli
