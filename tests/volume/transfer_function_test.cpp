#include "oc_core/volume/transfer_function.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace ocelli
