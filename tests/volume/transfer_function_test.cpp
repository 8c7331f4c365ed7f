#include "oc_core/volume/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "oc_core/volume/transfer_integral.h"

namespace ocelli {
namespace {

TEST(TransferFunction, KeepsTheShareOfASlabThatItsOpacitySays) {
  const TransferFunction transfer({{0, {1, 0, 0}, 0}, {10, {0, 1, 0}, 0.8}}, 2);
  EXPECT_NEAR(std::exp(-2 * transfer.at(5).extinction), 1 - 0.4, 1e-12);
  EXPECT_DOUBLE_EQ(transfer.at(5).color.x, 0.5);
  EXPECT_EQ(transfer.at(-1).extinction, 0);
  EXPECT_DOUBLE_EQ(transfer.at(20).extinction, transfer.at(10).extinction);
}

TEST(TransferFunction, StepsWhereTwoPointsHaveOneValue) {
  const TransferFunction transfer({{0, {}, 0}, {1, {}, 0}, {1, {}, 0.5}, {2, {}, 0.5}}, 1);
  EXPECT_EQ(transfer.at(0.999).extinction, 0);
  EXPECT_NEAR(transfer.at(1).extinction, std::log(2), 1e-12);
}

/// By a million midpoints.
glm::dvec4 sampledIntegral(const TransferFunction& transfer, double first, double last) {
  constexpr int kParts = 1000000;
  glm::dvec4 sum(0);
  for (int i = 0; i < kParts; ++i) {
    const OpticalSample sample = transfer.at(first + (last - first) * (i + 0.5) / kParts);
    sum += glm::dvec4(1, sample.color) * sample.extinction;
  }
  return sum * ((last - first) / kParts);
}

TEST(TransferFunction, HasTheIntegralOfItsSamples) {
  const TransferFunction transfer(
      {{10, {1, 0, 0}, 0.3}, {12, {0, 1, 0.2}, 1}, {12, {0, 1, 1}, 0}, {13, {1, 1, 0}, 0.999}, {20, {0, 0, 1}, 0}}, 3);
  const std::pair<double, double> ranges[] = {{0, 9}, {0, 11}, {10.5, 10.7}, {11, 12}, {11.9, 12.1}, {5, 30}, {21, 22}};
  for (const auto& [first, last] : ranges) {
    const glm::dvec4 expected = sampledIntegral(transfer, first, last);
    const glm::dvec4 got = transferIntegral(transfer, first, last);
    for (int c = 0; c < 4; ++c) {
      // A step is off by half a part of what it changes, 9.2 / 3 of extinction.
      EXPECT_NEAR(got[c], expected[c], (last - first) * 1e-6 * 2) << first << " to " << last << ", " << c;
    }
  }
  EXPECT_EQ(transferIntegral(transfer, 11, 11), glm::dvec4(0));
}

TEST(TransferFunction, HasTheIntegralOfAPeakOfAnyWidth) {
  for (const double width : {1e-9, 1e-3, 1.0, 1e6}) {
    const TransferFunction peak({{0, {1, 1, 1}, 0}, {width, {1, 1, 1}, 1}, {2 * width, {1, 1, 1}, 0}}, 1);
    // The integral of -ln(1 - o) from 0 to 1 is 1, of which the bound of opacities takes a ten-thousandth.
    EXPECT_NEAR(transferIntegral(peak, -1, 3e6).x / (2 * width), 1 - 1e-4, 1e-6) << width;
  }
}

}  // namespace
}  // namespace ocelli
