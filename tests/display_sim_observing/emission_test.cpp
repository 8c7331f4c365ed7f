#include "display_sim/observing/emission.h"

#include <gtest/gtest.h>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/observing/observer.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;

constexpr Emission kScreen{.model = EmissionModel::kScreen};

double lightOf(const Volume& volume, ObserverOptions options, const Emission& emission) {
  options.emission = emission;
  return test::sumOf(collectLight(volume, options)).x;
}

/// One voxel a slice, all at one height and distance from the axis.
Volume ring(const DisplayProfile& profile, int column) {
  Volume volume(profile);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    volume.light(slice, column, profile.height / 2, kAllChannels);
  }
  return volume;
}

// The factor is pi / 2 |n p| / z. Within the arc it changes by up to (pi / 2) (step / 2), evenly but for (step / 2)^2 /
// 6 of it: 5e-5 here. The rest are the whole numbers that light is counted in: a voxel is spread over some 20 pixels.
TEST(Emission, aScreensLightFallsWithTheCosine) {
  const DisplayProfile profile = smallProfile(90, 64, 64);
  const SweepGeometry sweep(profile);
  const glm::dvec3 eye(0, 2, 12);
  for (const int slice : {0, 10, 40, 44, 46, 80}) {
    for (const int column : {3, 40}) {
      Volume volume(profile);
      volume.light(slice, column, 20, kAllChannels);
      const ObserverOptions options{.eye = eye, .width = 200, .height = 200};
      const double t = slice * sweep.stepRadians();
      const glm::dvec3 p = sweep.voxelCenter(slice, column, 20) - eye;
      const double expected =
          kPi / 2 * std::abs(glm::dot(p, glm::dvec3(-std::sin(t), 0, std::cos(t)))) / glm::dot(p, -glm::normalize(eye));
      const double ratio = lightOf(volume, options, kScreen) / lightOf(volume, options, {});
      EXPECT_NEAR(ratio, expected, 1e-3) << slice << " " << column;
    }
  }
}

// From afar the factors of the slices are pi / 2 |cos|, whose mean over N slices is 1 but for (pi / N)^2 / 12.
TEST(Emission, aScreenSendsAsMuchAsALampOverATurn) {
  const DisplayProfile profile = smallProfile(60, 32, 32);
  const Volume volume = ring(profile, 24);
  const ObserverOptions options{.eye = {400, 0, 300}, .width = 100, .height = 100};
  EXPECT_NEAR(lightOf(volume, options, kScreen) / lightOf(volume, options, {}), 1, 1e-3);
}

TEST(Emission, aScreenIsDarkFromItsEdge) {
  const Volume volume = ring(smallProfile(60, 32, 32), 24);
  const ObserverOptions above{.eye = {0, 7, 0}, .width = 100, .height = 100};
  EXPECT_GT(lightOf(volume, above, {}), 10);
  EXPECT_NEAR(lightOf(volume, above, kScreen), 0, 1e-9);
}

// The radiance of a diffuse sheet is the same from everywhere: light for image area is pi / 2 d^2 / (a f^2), as
// ambient_light.h derives, with a voxel's area a and f pixels for one unit at distance 1. Pixels take whole boxes or
// not: about a hundredth of the light of 40 x 40.
TEST(Emission, aSheetIsAsBrightFromEverySide) {
  const DisplayProfile profile = smallProfile(400, 128, 128);
  Volume volume(profile);
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      volume.light(0, column, row, kAllChannels);
    }
  }
  for (const glm::vec3& eye : {glm::vec3(0, 0, 10), glm::vec3(7, 0, 7), glm::vec3(4, 5, -6)}) {
    const ObserverOptions options{.eye = eye, .width = 300, .height = 300, .emission = kScreen};
    const double d = glm::length(eye);
    const double f = 150 / std::tan(std::asin(1 / d));
    const double sheet = kPi / 2 * d * d / (f * f) * (64 * 64);
    EXPECT_NEAR(test::middleOf(collectLight(volume, options), 20) / sheet, 1, 0.01);
  }
}

// For an eye on the z axis, slices of less than a quarter turn show it their front, the others their back; half a turn
// later it is the other way round. 1.6 and 0.4 are 2 / (1 + T) and 2 T / (1 + T).
TEST(Emission, theBackIsDimmerByTheTransmission) {
  const DisplayProfile profile = smallProfile(40, 32, 32);
  const double halfStep = 180.0 / 40 / 2;
  const Emission dim{.model = EmissionModel::kScreen, .transmission = 0.25};
  for (const int slice : {5, 30}) {
    Volume volume(profile);
    volume.light(slice, 24, 16, kAllChannels);
    ObserverOptions options{.width = 100, .height = 100, .startDegrees = -halfStep};
    const bool front = slice < 20;
    EXPECT_NEAR(lightOf(volume, options, dim) / lightOf(volume, options, kScreen), front ? 1.6 : 0.4, 1e-4) << slice;
    options.startDegrees = 180 - halfStep;
    EXPECT_NEAR(lightOf(volume, options, dim) / lightOf(volume, options, kScreen), front ? 0.4 : 1.6, 1e-4) << slice;
    options.exposureSeconds = 1.0 / 12;
    EXPECT_NEAR(lightOf(volume, options, dim) / lightOf(volume, options, kScreen), 1, 1e-4) << slice;
  }
}

// The own second half turn tells by its slices which face is ahead.
TEST(Emission, anOwnSecondHalfTurnShowsTheOtherFace) {
  const DisplayProfile profile = smallProfile(40, 32, 32, SecondHalfTurn::kOwn);
  const Emission dim{.model = EmissionModel::kScreen, .transmission = 0.25};
  Volume volume(profile);
  volume.light(5, 24, 16, 1);
  volume.light(45, 7, 16, 2);  // the same place: column 7 is opposite to 24
  ObserverOptions options{.width = 100, .height = 100, .emission = dim};
  const glm::dvec3 sum = test::sumOf(collectLight(volume, options));
  EXPECT_NEAR(sum.x / sum.y, 4, 1e-3);
}

}  // namespace
}  // namespace ocelli
