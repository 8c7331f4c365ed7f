#include "oc_core/remote/region_wishes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/random_numbers.h"
#include "oc_core/camera/gpc_map.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

/// Samples for each one of the pinhole at a place of its image, shares.
double rateAt(const std::vector<GpcRegion>& regions, const glm::dvec2& pinhole) {
  constexpr int kPixels = 1000;
  const GpcMap map({.sampling = findGpcSampling("cubic"), .regions = regions}, kPixels, kPixels);
  return map.rateAt(map.imageFromPinhole(pinhole * double{kPixels}));
}

void expectValid(const std::vector<GpcRegion>& regions) {
  EXPECT_NO_THROW(validate(GpcLayout{.regions = regions}, "regions"));
}

TEST(RegionWishes, OneThatFitsBecomesARegion) {
  const std::vector<GpcRegion> regions =
      regionsOf({{.center = {0.4, 0.6}, .content = {0.1, 0.05}, .zoom = 3, .transition = 0.5}});
  ASSERT_EQ(regions.size(), 1u);
  // The content, three times as large.
  EXPECT_NEAR(regions[0].extent.x, 0.3, 1e-6);
  EXPECT_NEAR(regions[0].extent.y, 0.15, 1e-6);
  EXPECT_FLOAT_EQ(regions[0].transitionWidth, 0.5f);
  EXPECT_NEAR(rateAt(regions, {0.4, 0.6}), 3, 1e-9);
  EXPECT_NEAR(rateAt(regions, {0.449, 0.6}), 3, 1e-9);  // to the edge of the content
}

TEST(RegionWishes, WhatTheImageHasAnywayIsLeftOut) {
  EXPECT_TRUE(regionsOf({{.zoom = 1}, {.zoom = 0.5}}).empty());
}

TEST(RegionWishes, AtABorderTheTransitionIsNarrowerAndThenLessIsShown) {
  // 0.2 from the border: half of 0.3 and a third of it.
  const auto narrow = regionsOf({{.center = {0.2, 0.5}, .content = {0.15, 0.1}, .zoom = 2, .transition = 1}});
  ASSERT_EQ(narrow.size(), 1u);
  EXPECT_NEAR(narrow[0].extent.x, 0.3, 1e-6);
  EXPECT_NEAR(narrow[0].transitionWidth, 1.0 / 3, 1e-3);
  // Half of 0.6 does not fit: 0.2 / 1.25 does.
  const auto less = regionsOf({{.center = {0.2, 0.5}, .content = {0.3, 0.1}, .zoom = 2, .transition = 1}});
  ASSERT_EQ(less.size(), 1u);
  EXPECT_NEAR(less[0].extent.x, 0.32, 1e-3);
  EXPECT_FLOAT_EQ(less[0].zoom, 2);
  // In a corner of the image nothing fits.
  EXPECT_TRUE(regionsOf({{.center = {0, 0}, .content = {0.3, 0.1}, .zoom = 2}}).empty());
}

TEST(RegionWishes, NeighboursShareTheRoomBetweenThem) {
  const auto regions = regionsOf({{.center = {0.3, 0.5}, .content = {0.1, 0.1}, .zoom = 2, .transition = 1},
                                  {.center = {0.6, 0.5}, .content = {0.1, 0.1}, .zoom = 2, .transition = 1}});
  ASSERT_EQ(regions.size(), 2u);
  expectValid(regions);
  // Centres 0.3 apart, half extents of 0.1: the two transitions have 0.1 together, and each takes some.
  EXPECT_NEAR(regions[0].transitionWidth + regions[1].transitionWidth, 1, 1e-3);
  EXPECT_THAT(regions, ElementsAre(testing::Field(&GpcRegion::transitionWidth, testing::Gt(0.25f)),
                                   testing::Field(&GpcRegion::transitionWidth, testing::Gt(0.25f))));
}

TEST(RegionWishes, OverlappingOnesShareARegionWithTheHigherZoom) {
  const auto regions = regionsOf({{.center = {0.45, 0.5}, .content = {0.06, 0.06}, .zoom = 2},
                                  {.center = {0.55, 0.5}, .content = {0.06, 0.06}, .zoom = 4}});
  ASSERT_EQ(regions.size(), 1u);
  expectValid(regions);
  EXPECT_FLOAT_EQ(regions[0].zoom, 4);
  EXPECT_NEAR(regions[0].extent.x, 0.16 * 4, 1e-5);  // both contents, from 0.42 to 0.58
  EXPECT_NEAR(rateAt(regions, {0.43, 0.5}), 4, 1e-9);
  EXPECT_NEAR(rateAt(regions, {0.57, 0.5}), 4, 1e-9);
}

TEST(RegionWishes, TheHigherZoomIsLessWhereThereIsNoRoomForIt) {
  const auto regions = regionsOf({{.center = {0.3, 0.5}, .content = {0.2, 0.1}, .zoom = 2},
                                  {.center = {0.6, 0.5}, .content = {0.2, 0.1}, .zoom = 8}});
  ASSERT_EQ(regions.size(), 1u);
  expectValid(regions);
  // Alone, the second shows 0.4 / 1.25 / 8 to each side of 0.6: so both show from 0.2 to 0.64, around 0.42. That is
  // half of what there is, with the narrowest transition 0.42 / 1.25.
  EXPECT_NEAR(regions[0].zoom, 0.42 / 1.25 / 0.22, 1e-3);
  EXPECT_GT(rateAt(regions, {0.21, 0.5}), 1.4);
}

TEST(RegionWishes, TheYieldingOneGetsSmallerAndThenGoes) {
  const RegionWish middle{.center = {0.5, 0.5}, .content = {0.2, 0.2}, .zoom = 2, .transition = 1};
  EXPECT_EQ(regionsOf({}, middle).size(), 1u);
  const auto beside =
      regionsOf({{.center = {0.2, 0.5}, .content = {0.05, 0.05}, .zoom = 3, .transition = 0.25}}, middle);
  ASSERT_EQ(beside.size(), 2u);
  expectValid(beside);
  EXPECT_LT(beside[1].extent.x, 0.4);
  EXPECT_GE(beside[1].extent.x, 0.2);
  EXPECT_EQ(regionsOf({{.center = {0.5, 0.5}, .content = {0.05, 0.05}, .zoom = 3}}, middle).size(), 1u);
}

TEST(RegionWishes, AnyWishesGiveValidRegions) {
  RandomNumbers random(17);
  const auto between = [&](double least, double most) { return least + (most - least) * random.uniform(); };
  for (int round = 0; round < 3000; ++round) {
    std::vector<RegionWish> wishes(random.below(9));
    for (RegionWish& wish : wishes) {
      wish = {.center = {between(-0.2, 1.2), between(-0.2, 1.2)},
              .content = {std::pow(10, between(-5, 0.2)), std::pow(10, between(-5, 0.2))},
              .zoom = std::pow(10, between(-1, 2)),
              .transition = std::pow(10, between(-2, 2))};
    }
    const RegionWish middle{.content = glm::dvec2(between(0.05, 0.9)), .zoom = between(1, 16), .transition = 10};
    expectValid(regionsOf(wishes));
    expectValid(regionsOf(wishes, middle));
    EXPECT_LE(regionsOf(wishes).size(), wishes.size());
  }
}

}  // namespace
}  // namespace ocelli
