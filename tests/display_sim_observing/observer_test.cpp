#include "display_sim/observing/observer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;
using test::sumOf;

/// White and right across the display, at height 0.
Volume whiteFloor(const DisplayProfile& profile) {
  Mesh mesh;
  test::addTriangle(mesh, {-9, 0.01f, -9}, {9, 0.01f, -9}, {0, 0.01f, 9});
  return sliceExactly(mesh, profile);
}

// A voxel's light, spread over arcs and pixels, is (d / z)^2, z between the nearest and the farthest point of its cell.
// The rest is the 2^-24 of the fixed point and of floats.
TEST(Observer, aVoxelsLightIsConserved) {
  const DisplayProfile profile = smallProfile(20, 32, 32);
  const SweepGeometry sweep(profile);
  for (const glm::vec3& eye : {glm::vec3(0, 0, 10), glm::vec3(3, 4, -2), glm::vec3(0, 7, 0)}) {
    for (const int slice : {0, 7, 19}) {
      for (const int column : {0, 15, 16, 27}) {
        Volume volume(profile);
        volume.light(slice, column, 12, 5);
        const glm::dvec3 sum = sumOf(collectLight(volume, {.eye = eye, .width = 300, .height = 200}));
        const double distance = glm::length(glm::dvec3(eye));
        const double z = distance - glm::dot(sweep.voxelCenter(slice, column, 12), glm::dvec3(eye) / distance);
        const double cell = std::hypot(sweep.stepRadians() / 2, 1.0 / 32);
        EXPECT_GE(sum.x, std::pow(distance / (z + cell), 2) - 1e-5);
        EXPECT_LE(sum.x, std::pow(distance / (z - cell), 2) + 1e-5);
        EXPECT_EQ(sum.y, 0);
        EXPECT_EQ(sum.z, sum.x);
      }
    }
  }
}

TEST(Observer, aVoxelAppearsWhereItIs) {
  const DisplayProfile profile = smallProfile(90, 64, 64);
  // Slice 0 is the plane z = 0, seen straight on from (0, 0, 10): 100 pixels hold tan(asin(0.1)) x 10 radii.
  Volume volume(profile);
  volume.light(0, 50, 10, 7);
  const Image<glm::vec3> image = collectLight(volume, {.width = 200, .height = 200});
  glm::dvec2 centroid(0);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      centroid += glm::dvec2(x + 0.5, y + 0.5) * static_cast<double>(image(x, y).x);
    }
  }
  centroid /= sumOf(image).x;
  const double pixelsPerRadius = 100 / (10 * std::tan(std::asin(0.1)));
  // The cell's arc bulges towards and away from the eye; that moves its image by less than a hundredth of a pixel.
  EXPECT_NEAR(centroid.x, 100 + pixelsPerRadius * (50.5 - 32) / 32, 0.01);
  EXPECT_NEAR(centroid.y, 100 - pixelsPerRadius * (32 - 10.5) / 32, 0.01);
}

TEST(Observer, lightAddsAndNothingHides) {
  const DisplayProfile profile = smallProfile(20, 48, 48);
  const Mesh small = test::sphere(0.3, 12);
  const Mesh large = test::sphere(0.9, 12);
  Mesh both = small;
  append(both, large);
  const ObserverOptions options{.width = 100, .height = 100};
  const Image<glm::vec3> a = collectLight(sliceExactly(small, profile), options);
  const Image<glm::vec3> b = collectLight(sliceExactly(large, profile), options);
  const Image<glm::vec3> sum = collectLight(sliceExactly(both, profile), options);
  EXPECT_GT(b(50, 50).x, 0) << "the large sphere is before the small one";
  for (size_t i = 0; i < sum.size(); ++i) {
    EXPECT_FLOAT_EQ(sum[i].x, a[i].x + b[i].x);
  }
}

/// Angle in degrees, modulo a half turn, of the point of the plane y = 0 that a pixel shows, seen from above, and its
/// radius.
struct FloorPoint {
  double degrees;
  double radius;
};

constexpr int kFloorSize = 300;

FloorPoint floorPointOf(int x, int y) {
  const double radiusPerPixel = 10 * std::tan(std::asin(0.1)) / (kFloorSize / 2.0);
  const double px = (x + 0.5 - kFloorSize / 2.0) * radiusPerPixel;
  const double pz = (y + 0.5 - kFloorSize / 2.0) * radiusPerPixel;  // far from the default eye is up
  return {std::fmod(degreesFromRadians(std::atan2(pz, px)) + 360, 180), std::hypot(px, pz)};
}

TEST(Observer, exactlyTheMissingSectorIsDark) {
  const Volume floor = whiteFloor(loadProfile("perspecta"));
  const double start = 30;
  const Image<glm::vec3> image = collectLight(floor, {.eye = {0, 10, 0},
                                                      .width = kFloorSize,
                                                      .height = kFloorSize,
                                                      .exposureSeconds = 1.0 / 25,
                                                      .missingSectorStartDegrees = start});
  int dark = 0;
  for (int y = 0; y < kFloorSize; ++y) {
    for (int x = 0; x < kFloorSize; ++x) {
      const FloorPoint p = floorPointOf(x, y);
      // A pixel's corner is up to 0.71 pixels from its centre, the floor's images up to 1.5 (a box of a part of an
      // arc).
      const double slack = degreesFromRadians(std::atan(2.2 / (kFloorSize / 2.0) / p.radius));
      const bool within = p.degrees > start + slack && p.degrees < start + 7.2 - slack;
      const bool beside = p.degrees < start - slack || p.degrees > start + 7.2 + slack;
      if (within && p.radius < 1.1) {
        EXPECT_EQ(image(x, y), glm::vec3(0)) << x << " " << y;
        ++dark;
      } else if (beside && p.radius < 0.97) {
        EXPECT_GT(image(x, y).x, 0) << x << " " << y;
      }
    }
  }
  EXPECT_GT(dark, 500);
}

// Even where the screen moves by several voxels from slice to slice, the image of an even floor shows no gaps. Voxels
// of equal light stand in rings of N: light for the area falls as 1 / r.
TEST(Observer, noGapsBetweenSlicesAtTheRim) {
  const DisplayProfile profile = smallProfile(60, 128, 128);  // at the rim a step is 3.4 columns
  for (const int size : {kFloorSize, 2 * kFloorSize}) {
    const Image<glm::vec3> image =
        collectLight(whiteFloor(profile), {.eye = {0, 10, 0}, .width = size, .height = size});
    double least = 1e9;
    double most = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const double scale = static_cast<double>(kFloorSize) / size;
        const double px = (x + 0.5 - size / 2.0) * scale;
        const double py = (y + 0.5 - size / 2.0) * scale;
        const double radius = std::hypot(px, py) / (kFloorSize / 2.0);
        if (radius > 0.5 && radius < 0.95) {
          least = std::min(least, image(x, y).x * radius);
          most = std::max(most, image(x, y).x * radius);
        }
      }
    }
    // Where the sweep runs diagonally through the image, boxes of about a pixel stand for turned squares of the same
    // spread and ripple by up to a quarter either way. A gap would be 0.
    EXPECT_GT(least, 0.6 * most) << size;
  }
}

TEST(Observer, longExposuresCollectMoreLight) {
  const Volume floor = whiteFloor(smallProfile(20, 32, 32));
  const ObserverOptions options{.width = 64, .height = 64};
  const Image<glm::vec3> once = collectLight(floor, options);
  ObserverOptions longer = options;
  longer.exposureSeconds = 3.0 / 24;
  const Image<glm::vec3> thrice = collectLight(floor, longer);
  for (size_t i = 0; i < once.size(); ++i) {
    EXPECT_NEAR(thrice[i].x, 3 * once[i].x, 1e-5f * thrice[i].x + 1e-5f);  // fixed point rounds each share to 2^-24
  }
  longer.exposureSeconds = 1.5 / 24;
  EXPECT_NEAR(sumOf(collectLight(floor, longer)).x / sumOf(once).x, 1.5, 1e-3) << "near and far halves cancel";
}

// 1.2e8 passes of 40960 voxels that emit 1 in each, into one pixel: 2^66 units of 2^-24. They are whole half turns, so
// the rest is rounding.
TEST(Observer, theLongestExposureOfTheFastestDisplayFits) {
  DisplayProfile profile = smallProfile(40, 32, 32);
  profile.rotationsPerMinute = 1e6;
  Volume volume(profile);
  for (int slice = 0; slice < 40; ++slice) {
    std::ranges::fill(volume.slice(slice), uint8_t{0xff});
  }
  const ObserverOptions once{.eye = {0, 10, 0}, .width = 1, .height = 1};
  ObserverOptions longest = once;
  longest.exposureSeconds = 3600;
  const double passes = 3600 * 2 * 1e6 / 60;
  EXPECT_NEAR(collectLight(volume, longest)(0, 0).x / (passes * collectLight(volume, once)(0, 0).x), 1, 1e-5);
}

TEST(Observer, theSmallestFieldOfViewIsSafe) {
  const Volume floor = whiteFloor(smallProfile(20, 32, 32));
  const ObserverOptions options{.eye = {0.01f, 10, 0.02f}, .width = 8, .height = 8, .fovVerticalDegrees = 1e-6};
  for (const glm::vec3& pixel : collectLight(floor, options)) {
    EXPECT_TRUE(std::isfinite(pixel.x) && pixel.x >= 0);
  }
}

TEST(Observer, halfATurnShowsHalfOfOwnSlices) {
  const DisplayProfile profile = smallProfile(10, 32, 32, SecondHalfTurn::kOwn);
  Volume volume(profile);
  volume.light(3, 20, 16, 1);
  volume.light(13, 20, 16, 2);
  ObserverOptions options{.width = 64, .height = 64};
  options.exposureSeconds = 1.0 / 24;
  options.missingSectorStartDegrees = 171;
  const glm::dvec3 half = sumOf(collectLight(volume, options));
  EXPECT_GT(half.x, 0.5);
  EXPECT_EQ(half.y, 0);
  options.exposureSeconds = 0;
  const glm::dvec3 whole = sumOf(collectLight(volume, options));
  EXPECT_GT(whole.x, 0.5);
  EXPECT_GT(whole.y, 0.5);
}

// Voxels at the axis, seen from straight above, have no extent along the sweep.
TEST(Observer, lightWithoutExtentIsNotLost) {
  Volume volume(smallProfile(4, 9, 9));
  volume.light(0, 4, 4, 7);
  const Image<glm::vec3> image = collectLight(volume, {.eye = {0, 7, 0}, .width = 61, .height = 61});
  EXPECT_NEAR(sumOf(image).x, 1, 1e-3);  // it stands at the centre, where light is not scaled by distance
}

TEST(Observer, nothingIsSeenInTheDeadZone) {
  const DisplayProfile profile = smallProfile(20, 32, 32);
  Volume inside(profile);
  Volume outside(profile);
  for (int column = 0; column < 32; ++column) {
    const bool dead = column >= 11 && column < 21;  // r up to 4.5 / 16
    (dead ? inside : outside).light(7, column, 12, 7);
  }
  Volume both = outside;
  for (int column = 11; column < 21; ++column) {
    both.light(7, column, 12, 7);
  }
  const ObserverOptions shaft{.width = 100, .height = 100, .deadZoneRadii = 0.3};
  EXPECT_EQ(collectLight(both, shaft), collectLight(outside, {.width = 100, .height = 100}));
  EXPECT_EQ(sumOf(collectLight(inside, shaft)), glm::dvec3(0));
  EXPECT_THROW(collectLight(both, {.deadZoneRadii = 1}), InputError);
}

// Red is on during the first third of the arc, blue during the last: their light is a third each, and their middles are
// two thirds of a step apart.
TEST(Observer, channelsInTurnLeaveColorFringes) {
  DisplayProfile profile = smallProfile(20, 64, 64);
  profile.channelTiming = ChannelTiming::kInTurn;
  Volume volume(profile);
  volume.light(10, 60, 32, 7);  // towards the default eye; the sweep goes along -x
  const ObserverOptions options{.width = 400, .height = 400};
  const Image<glm::vec3> image = collectLight(volume, options);
  const double r = 28.5 / 32;
  const glm::dvec3 sum = sumOf(image);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(sum[channel], std::pow(10 / (10 - r), 2) / 3, 2e-3);  // the arc's ends are farther: 1 - cos(step / 2)
  }
  const double pixels = 200 / std::tan(std::asin(0.1)) / (10 - r);
  const double apart = test::spreadOf(image, 0).center.x - test::spreadOf(image, 2).center.x;
  EXPECT_NEAR(apart, kPi / 20 * 2 / 3 * r * pixels, 0.01 * apart);  // sin of a tenth for the angle: 0.2 %
  profile.channelTiming = ChannelTiming::kTogether;
  Volume together(profile);
  together.light(10, 60, 32, 7);
  EXPECT_NEAR(sumOf(collectLight(together, options)).y, sum.x + sum.y + sum.z, 1e-3);
}

TEST(Observer, sameBytesWithAnyNumberOfThreads) {
  Mesh mesh = test::torus(0.6, 0.3, 60, 40);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p));
  }
  const Volume volume = sliceExactly(mesh, smallProfile(50, 96, 96));
  const ObserverOptions plain{.eye = {2, 1, 2}, .width = 120, .height = 90};
  ObserverOptions full = plain;
  full.exposureSeconds = 2.7 / 24;
  full.emission = {.model = EmissionModel::kScreen, .transmission = 0.3};
  full.wobble = {.amplitudeRadii = 0.05, .frequency = 1.3};
  full.lens = {.apertureRadii = 0.1, .focusRadii = 2.5};
  full.ambient = 0.01;
  full.tone.curve = ToneCurve::kFilmic;
  for (const ObserverOptions& options : {plain, full}) {
    setThreadCount(1);
    const Image<glm::vec3> one = observe(volume, options);
    for (const int threads : {2, 8}) {
      setThreadCount(threads);
      EXPECT_EQ(observe(volume, options), one) << threads;
    }
  }
  setThreadCount(0);
}

TEST(Observer, badOptionsAreInputErrors) {
  const Volume volume(smallProfile(4, 8, 8));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(observe(volume, {.eye = {0.3f, 0.5f, 0.3f}}), InputError) << "inside of the display";
  EXPECT_THROW(observe(volume, {.eye = {0, 0, 0}}), InputError);
  EXPECT_THROW(observe(volume, {.eye = {0, 0, 1}}), InputError);
  EXPECT_THROW(observe(volume, {.eye = {0, nan, 9}}), InputError);
  EXPECT_THROW(observe(volume, {.width = 0}), InputError);
  EXPECT_THROW(observe(volume, {.width = 1 << 15, .height = 1 << 15}), InputError);
  EXPECT_THROW(observe(volume, {.fovVerticalDegrees = 180}), InputError);
  for (const double fov : {1e-309, 1e-300, 1e-7, -1.0, static_cast<double>(nan)}) {
    EXPECT_THROW(observe(volume, {.fovVerticalDegrees = fov}), InputError) << fov;
  }
  EXPECT_THROW(observe(volume, {.exposureSeconds = -1}), InputError);
  EXPECT_THROW(observe(volume, {.tone = {.gain = -1}}), InputError);
  EXPECT_THROW(observe(volume, {.tone = {.gamma = 0}}), InputError);
  EXPECT_NO_THROW(observe(volume, {.eye = {0, 0, 1.1f}}));
}

TEST(Observer, anEyeCloseByIsSafe) {
  const Volume volume = sliceExactly(test::sphere(0.99, 20), smallProfile(20, 32, 32));
  for (const double aperture : {0.0, 0.5}) {
    const ObserverOptions options{.eye = {1.01f, 0, 0}, .width = 64, .height = 64, .lens = {.apertureRadii = aperture}};
    for (const glm::vec3& pixel : observe(volume, options)) {
      EXPECT_TRUE(std::isfinite(pixel.x));
    }
  }
}

}  // namespace
}  // namespace ocelli
