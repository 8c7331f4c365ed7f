#include "display_sim/observing/lens.h"

#include <gtest/gtest.h>

#include "display_sim/observing/observer.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

constexpr int kLensSide = 400;
constexpr double kFovDegrees = 3;
const double kPixelsPerTangent = kLensSide / 2.0 / std::tan(radiansFromDegrees(kFovDegrees / 2));

/// A voxel on the z axis: of the slice of a quarter turn, so many radii before the display's centre.
Volume voxelBefore(int columnsFromAxis) {
  const DisplayProfile profile = test::smallProfile(40, 65, 65);
  Volume volume(profile);
  volume.light(20, 32 + columnsFromAxis, 32, 7);
  return volume;
}

test::Spread seen(const Volume& volume, const Lens& lens) {
  return test::spreadOf(
      collectLight(volume, {.width = kLensSide, .height = kLensSide, .fovVerticalDegrees = kFovDegrees, .lens = lens}));
}

TEST(Lens, circleOfConfusionIsThatOfAThinLens) {
  // A pupil of 2, focused at 10: rays from a point at 5 cross, and at 10 they are 2 (10 - 5) / 5 = 2 apart, seen at 10.
  EXPECT_NEAR(circleOfConfusion(2, 10, 5, 700), 700 * 2.0 / 10, 1e-9);
  // Behind it: at 20, where the pupil's cone has 2 (20 - 10) / 20 = 1 left.
  EXPECT_NEAR(circleOfConfusion(2, 10, 20, 700), 700 * 1.0 / 10, 1e-9);
  EXPECT_EQ(circleOfConfusion(2, 10, 10, 700), 0);
  EXPECT_EQ(circleOfConfusion(0, 10, 5, 700), 0);
}

// A disc adds diameter^2 / 16 to the variance. The voxel, a cell 2 / 65 deep, spans a range of depths in which the
// diameter changes by up to 4 % to either side: below 0.1 % of the variance. Filling rows of pixels with boxes takes up
// to 0.2 pixels^2 (light_splat_test.cpp), 0.5 % here.
TEST(Lens, aVoxelOutOfFocusIsADisc) {
  const double aperture = 0.8;
  for (const int columns : {28, 14, -25}) {
    const Volume volume = voxelBefore(columns);
    const double z = 10 - columns * 2.0 / 65;
    const test::Spread sharp = seen(volume, {});
    const test::Spread blurred = seen(volume, {.apertureRadii = aperture});
    const double diameter = circleOfConfusion(aperture, 10, z, kPixelsPerTangent);
    const double variance = diameter * diameter / 16;
    EXPECT_GT(diameter, 25);
    EXPECT_NEAR(blurred.variance.x - sharp.variance.x, variance, 6e-3 * variance);
    EXPECT_NEAR(blurred.variance.y - sharp.variance.y, variance, 6e-3 * variance);
    EXPECT_NEAR(blurred.center.x, sharp.center.x, 0.02);
    EXPECT_NEAR(blurred.center.y, sharp.center.y, 0.02);
  }
}

// The cell's near and far ends are out of focus by half its depth: 1.5 pixels at most.
TEST(Lens, whatIsInFocusStaysSharp) {
  const Volume volume = voxelBefore(28);
  const Lens lens{.apertureRadii = 0.8, .focusRadii = 10 - 28 * 2.0 / 65};
  EXPECT_LT(seen(volume, lens).variance.y - seen(volume, {}).variance.y, 1.5 * 1.5 / 16);
  EXPECT_GT(seen(volume, {.apertureRadii = 0.8}).variance.y - seen(volume, {}).variance.y, 100);
}

// A disc of less than a voxel's image is added to its box, to the same variance. A pixel at the box's rim counts at its
// centre, up to half a pixel from its light, which is up to 1 / 25 of all and 12.5 pixels from the middle: 1 / 8 at
// each of four rims, of which two come in and two go.
TEST(Lens, aLittleBlurWidensTheBox) {
  const Volume volume = voxelBefore(28);
  const double diameter = circleOfConfusion(0.1, 10, 10 - 28 * 2.0 / 65, kPixelsPerTangent);
  EXPECT_GT(diameter, 3);
  EXPECT_LT(diameter, 20);  // a voxel is 25 pixels high
  const double variance = diameter * diameter / 16;
  EXPECT_NEAR(seen(volume, {.apertureRadii = 0.1}).variance.y - seen(volume, {}).variance.y, variance, 0.25);
}

TEST(Lens, lightIsNotLost) {
  const Volume volume = voxelBefore(20);
  const ObserverOptions options{.width = kLensSide, .height = kLensSide, .fovVerticalDegrees = kFovDegrees};
  ObserverOptions wide = options;
  wide.lens.apertureRadii = 0.5;
  // 2^-24 of rounding for each of some thousand pixels a part.
  EXPECT_NEAR(test::sumOf(collectLight(volume, wide)).x, test::sumOf(collectLight(volume, options)).x, 1e-3);
}

TEST(Lens, badValuesAreInputErrors) {
  const Volume volume(test::smallProfile(4, 8, 8));
  EXPECT_THROW(collectLight(volume, {.lens = {.apertureRadii = -1}}), InputError);
  EXPECT_THROW(collectLight(volume, {.lens = {.apertureRadii = 2}}), InputError);
  EXPECT_THROW(collectLight(volume, {.lens = {.focusRadii = -1}}), InputError);
}

}  // namespace
}  // namespace ocelli
