#include "display_sim/volume_slicing/swept_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/display_sim_volume_slicing/swept_scenes.h"

namespace ocelli {
namespace {

using test::sweptProfile;

constexpr ValueRange kUnitRange{0, 1};

TEST(SweptLight, IsTheOpacityOfTheCellsThickness) {
  const SweepGeometry sweep(loadProfile("perspecta"));
  const glm::dvec3 color(1, 0.5, 0.25);
  for (const double opacity : {1e-3, 0.3, 0.95}) {
    const double unit = 0.01;
    const TransferFunction transfer({{0, color, opacity}}, 1);
    const SweptLight light(transfer, kUnitRange, unit, sweep);
    for (const int column : {0, 100, 300, 380, 383, 384, 390, 767}) {
      const double thickness = sweptThickness(sweep, column) / unit;  // in the unit of the opacity
      const double share = 1 - std::pow(1 - opacity, thickness);
      const glm::vec3 got = light.lightOf(sweptCode(0.5f, 0.1f), column);
      // Extinction and thickness are rounded to a 64th of an octave each, the opacity to 2^-12 of the brightest that
      // its column may have.
      const double tolerance = share * std::log(2.0) / 64 + share * 0x1p-11;
      EXPECT_NEAR(got.x, share, tolerance) << opacity << " " << column;
      EXPECT_NEAR(got.y, share / 2, tolerance);
      EXPECT_NEAR(got.z, share / 4, tolerance);
    }
  }
}

TEST(SweptLight, AveragesOverTheSpreadOfACell) {
  const SweepGeometry sweep(loadProfile("test"));
  // Red up to 0.5, then green of three times the extinction.
  const double thin = 0.01;
  const double thick = 1 - std::pow(1 - thin, 3);
  const TransferFunction transfer({{0, {1, 0, 0}, thin}, {0.5, {1, 0, 0}, thin}, {0.5, {0, 1, 0}, thick}}, 1);
  const SweptLight light(transfer, kUnitRange, 1, sweep);
  const uint16_t code = sweptCode(0.5f, 0.25f);
  // A quarter of the light is red, and together it is that of twice the thin extinction.
  const double extinction = -std::log1p(-thin) * 2;
  const double share = -std::expm1(-extinction * sweptThickness(sweep, 63));
  const glm::vec3 got = light.lightOf(code, 63);
  // Colours are in 256ths. Extinctions and thicknesses are in 64ths of an octave, rounded: half a step of each is 1.1
  // %; the spread in tenths of an octave takes no more from the two halves alike.
  EXPECT_NEAR(got.x / (got.x + got.y), 0.25, 2.0 / 256);
  EXPECT_NEAR(got.x + got.y, share, 0.02 * share);
}

TEST(SweptLight, MissesNoPeakHoweverThin) {
  const SweepGeometry sweep(loadProfile("test"));
  const double thickness = sweptThickness(sweep, 63);
  const uint16_t code = sweptCode(0.5f, 0.02f);
  const double spread = 2 * static_cast<double>(sweptHalfSpreadOf(code));
  // A hundredth of a step of the mean, at places that are not the same between steps; of all values that the cell has,
  // its optical depth is 1.
  const double width = 0.01 / (kSweptMeans - 1);
  const double length = -std::log(0.1) * thickness * width / spread;
  for (int i = 0; i < 20; ++i) {
    const double first = 0.49 + 0.00037 * i;
    const TransferFunction peak({{0, {1, 0.5, 0}, 0},
                                 {first, {1, 0.5, 0}, 0},
                                 {first, {1, 0.5, 0}, 0.9},
                                 {first + width, {1, 0.5, 0}, 0.9},
                                 {first + width, {1, 0.5, 0}, 0},
                                 {1, {1, 0.5, 0}, 0}},
                                length);
    const glm::vec3 got = SweptLight(peak, kUnitRange, 1, sweep).lightOf(code, 63);
    // Rounded to a 64th of an octave, as above.
    EXPECT_NEAR(got.x, 1 - std::exp(-1), 0.02) << first;
    EXPECT_NEAR(got.y, got.x / 2, 0.01) << first;
  }
}

TEST(SweptLight, ShowsValuesOfARangeAlone) {
  const SweepGeometry sweep(loadProfile("test"));
  const TransferFunction transfer({{0, {1, 1, 1}, 0.5}}, 0.01);
  const SweptLight light(transfer, {-1000, 3000}, 1, sweep, {.shown = ValueRange{0, 1000}});
  const auto codeOf = [](double value) { return sweptCode(static_cast<float>((value + 1000) / 4000), 0); };
  EXPECT_EQ(light.lightOf(codeOf(-10), 0), glm::vec3(0));
  EXPECT_GT(light.lightOf(codeOf(10), 0).x, 0);
  EXPECT_GT(light.lightOf(codeOf(990), 0).x, 0);
  EXPECT_EQ(light.lightOf(codeOf(1010), 0), glm::vec3(0));
}

/// Whatever code has light, the bricks that hold it must not be left out.
void expectNothingLeftOut(const SweptLight& light) {
  int lit = 0;
  for (size_t code = 0; code < kSweptCodes - 1; ++code) {
    if (light.entries()[code] == 0) {
      continue;
    }
    ++lit;
    const float step = sweptMeanOf(static_cast<uint16_t>(code)) * (kSweptMeans - 1);
    const float reach = sweptReach(sweptHalfSpreadOf(static_cast<uint16_t>(code)));
    const int first = std::max(static_cast<int>(std::floor(step - reach)), 0);
    const int last = std::min(static_cast<int>(std::ceil(step + reach)), kSweptMeans - 1);
    ASSERT_TRUE(light.mayBeLit(first, last)) << code;
  }
  EXPECT_GT(lit, 0);
  EXPECT_LT(lit, static_cast<int>(kSweptCodes) / 2);
}

TEST(SweptLight, TellsWhichBricksMayBeLit) {
  const SweepGeometry sweep(loadProfile("test"));
  // A peak between two steps of the mean, and one at the end.
  const double step = 1.0 / (kSweptMeans - 1);
  expectNothingLeftOut(
      SweptLight(TransferFunction({{0.3, {}, 0}, {0.3 + 0.3 * step, {1, 1, 1}, 0.9}, {0.3 + 0.6 * step, {}, 0}}, 1),
                 kUnitRange, 1, sweep));
  expectNothingLeftOut(SweptLight(TransferFunction({{0.999, {}, 0}, {1, {1, 1, 1}, 0.9}}, 1), kUnitRange, 1, sweep));
  expectNothingLeftOut(SweptLight::ofSurface(0.4321, {1, 1, 1}, kUnitRange, sweep));
  expectNothingLeftOut(SweptLight::ofSurface(1, {1, 1, 1}, kUnitRange, sweep));
  EXPECT_FALSE(SweptLight::ofSurface(2, {1, 1, 1}, kUnitRange, sweep).mayBeLit(0, kSweptMeans - 1));
}

TEST(SweptLight, OfASurfaceIsThatOfOneVoxel) {
  const SweepGeometry sweep(loadProfile("test"));
  const SweptLight light = SweptLight::ofSurface(0.5, {1, 1, 1}, kUnitRange, sweep);
  for (const double half : {0.01, 0.03, 0.1}) {
    // A row of cells whose values are 2 h apart, at any offset to the surface.
    for (double offset = 0; offset < 1; offset += 0.13) {
      double sum = 0;
      for (int i = -3; i <= 3; ++i) {
        const double mean = 0.5 + (i + offset) * 2 * half;
        sum += light.lightOf(sweptCode(static_cast<float>(mean), static_cast<float>(half)), 40).x;
      }
      // The spread is rounded by up to a tenth of an octave, which makes the step 7 % wider or narrower, and its
      // samples no longer sum to the same everywhere.
      EXPECT_NEAR(sum, 1, 0.1) << half << " " << offset;
    }
  }
  const uint16_t code = sweptCode(0.5f, 0.01f);
  EXPECT_EQ(SweptLight::ofSurface(sweptMeanOf(code), {1, 1, 1}, kUnitRange, sweep).lightOf(code, 40), glm::vec3(1));
}

}  // namespace
}  // namespace ocelli
