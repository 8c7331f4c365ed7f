#include "display_sim/volume_slicing/transfer_blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ocelli {
namespace {

TEST(TransferBlend, IsEitherAtItsEnds) {
  const TransferFunction from({{0, {1, 0, 0}, 0}, {1, {1, 0, 0}, 0.5}, {1, {0, 0, 0}, 0}}, 2);
  const TransferFunction to({{0.5, {0, 1, 0}, 0.1}, {3, {0, 1, 1}, 0.9}}, 0.5);
  for (double value = -1; value < 4; value += 0.37) {
    const TransferFunction start = blendedTransfer(from, to, 0);
    const TransferFunction end = blendedTransfer(from, to, 1);
    EXPECT_NEAR(start.at(value).extinction, from.at(value).extinction, 1e-9);
    // An extinction of 9.2 and more over the first one's length is cut to that. Over that length, four times the second
    // one's, opacities are linear between points that stand close to each other.
    const double wanted = std::min(to.at(value).extinction, -std::log(1e-4) / 2);
    EXPECT_NEAR(end.at(value).extinction, wanted, 0.01 * wanted);
    if (to.at(value).extinction > 0) {
      EXPECT_NEAR(end.at(value).color.z, to.at(value).color.z, 1e-9);
    }
  }
}

TEST(TransferBlend, MixesExtinctionsAndWeighsColors) {
  const TransferFunction from({{0, {1, 0, 0}, 0.2}}, 1);
  const TransferFunction to({{0, {0, 1, 0}, 0.6}}, 1);
  const OpticalSample sample = blendedTransfer(from, to, 0.25).at(0);
  const double red = -std::log(0.8) * 0.75;
  const double green = -std::log(0.4) * 0.25;
  EXPECT_NEAR(sample.extinction, red + green, 1e-12);
  EXPECT_NEAR(sample.color.y, green / (red + green), 1e-12);
}

TEST(TransferBlend, KeepsSteps) {
  const TransferFunction from({{0, {}, 0}, {1, {}, 0}, {1, {1, 1, 1}, 0.5}}, 1);
  const TransferFunction blended = blendedTransfer(from, TransferFunction({{0, {}, 0}}, 1), 0.5);
  EXPECT_EQ(blended.at(0.999).extinction, 0);
  EXPECT_NEAR(blended.at(1).extinction, std::log(2) / 2, 1e-12);
}

TEST(TransferSwing, goesThereInHalfOfAPeriodAndBack) {
  const TransferFunction from({{0, {1, 1, 1}, 0.2}}, 1);
  const TransferFunction to({{0, {1, 1, 1}, 0.6}}, 1);
  const TransferSwing swing(from, to, 4);
  // Seconds, and the share of the second one.
  for (const auto& [seconds, share] : {std::pair(0.0, 0.0), std::pair(1.0, 0.5), std::pair(2.0, 1.0),
                                       std::pair(3.5, 0.25), std::pair(4.0, 0.0), std::pair(41.0, 0.5)}) {
    const double expected = std::lerp(from.at(0).extinction, to.at(0).extinction, share);
    EXPECT_NEAR(swing.at(seconds).at(0).extinction, expected, 1e-12) << seconds;
  }
}

}  // namespace
}  // namespace ocelli
