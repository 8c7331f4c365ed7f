// Whatever a hand asks of lenses, their layout stays valid, and they get what is nearest to what was asked.
#include "oc_core/camera/gpc_lens_edit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/camera/random_lenses.h"

namespace ocelli {
namespace {

using test::kLensImage;
using test::RandomLenses;

GpcLayout twoLenses() {
  // With their transitions they take up [0.1, 0.3] and [0.6, 0.8] of the width, [0.4, 0.6] of the height.
  return {findGpcSampling("cubic"), {{{0.2f, 0.5f}, {0.1f, 0.1f}, 3, 1}, {{0.7f, 0.5f}, {0.1f, 0.1f}, 3, 1}}};
}

bool isValid(const GpcLayout& layout) {
  try {
    validate(layout, "test");
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

double pixelsBetween(const glm::dvec2& a, const glm::dvec2& b) {
  return glm::length((a - b) * kLensImage);
}

/// Single precision, of numbers up to 1, as the layout holds them.
constexpr double kSingleRounding = 1.2e-7;

TEST(GpcLensEdit, aLensGoesWhereItIsWantedWhereThereIsRoom) {
  GpcLayout layout = twoLenses();
  moveLens(layout, 0, {0.4, 0.3}, kLensImage);
  EXPECT_EQ(layout.regions[0].center, glm::vec2(0.4f, 0.3f));
  EXPECT_EQ(layout.regions[1], twoLenses().regions[1]);
}

TEST(GpcLensEdit, aLensStopsAtItsNeighbourAndSlidesAlongIt) {
  GpcLayout layout = twoLenses();
  for (const double y : {0.5, 0.52, 0.58}) {  // into the neighbour, and along it
    moveLens(layout, 0, {0.55, y}, kLensImage);
    EXPECT_NEAR(layout.regions[0].center.x, 0.5, kSingleRounding);
    EXPECT_NEAR(layout.regions[0].center.y, y, kSingleRounding);
  }
}

TEST(GpcLensEdit, aLensStopsAtTheBorderOfTheImage) {
  GpcLayout layout = twoLenses();
  moveLens(layout, 0, {-3, 0.45}, kLensImage);
  EXPECT_NEAR(layout.regions[0].center.x, 0.1, kSingleRounding);
  EXPECT_NEAR(layout.regions[0].center.y, 0.45, kSingleRounding);
}

TEST(GpcLensEdit, beyondTheMiddleOfANeighbourTheOtherSideIsNearer) {
  GpcLayout layout = twoLenses();
  moveLens(layout, 0, {0.85, 0.5}, kLensImage);
  EXPECT_NEAR(layout.regions[0].center.x, 0.9, kSingleRounding);
}

TEST(GpcLensEdit, distancesAreThoseOfPixels) {
  // Wanted 0.11 of the width and 0.15 of the height into the neighbour: 141 pixels and 108.
  GpcLayout layout = twoLenses();
  moveLens(layout, 0, {0.61, 0.35}, kLensImage);
  EXPECT_NEAR(layout.regions[0].center.x, 0.61, kSingleRounding);
  EXPECT_NEAR(layout.regions[0].center.y, 0.3, kSingleRounding);
  layout = twoLenses();
  moveLens(layout, 0, {0.61, 0.35}, {100, 1000});  // 11 pixels and 50
  EXPECT_NEAR(layout.regions[0].center.x, 0.5, kSingleRounding);
  EXPECT_NEAR(layout.regions[0].center.y, 0.35, kSingleRounding);
}

TEST(GpcLensEdit, aLensAsLargeAsTheImageStays) {
  GpcLayout layout;  // the default
  moveLens(layout, 0, {0.2, 0.9}, kLensImage);
  EXPECT_EQ(layout, GpcLayout{});
}

TEST(GpcLensEdit, aCornerMovesAndTheOppositeOneStays) {
  GpcLayout layout = twoLenses();
  dragLensCorner(layout, 0, LensCorner::kBottomRight, {0.35, 0.6}, kLensImage);
  EXPECT_NEAR(layout.regions[0].extent.x, 0.2, kSingleRounding);
  EXPECT_NEAR(layout.regions[0].extent.y, 0.15, kSingleRounding);
  const glm::dvec2 fixed = cornerOf(layout.regions[0], LensCorner::kTopLeft);
  EXPECT_NEAR(fixed.x, 0.15, kSingleRounding);
  EXPECT_NEAR(fixed.y, 0.45, kSingleRounding);
}

TEST(GpcLensEdit, aCornerStopsWhereTheTransitionTouches) {
  GpcLayout layout = twoLenses();
  dragLensCorner(layout, 0, LensCorner::kBottomRight, {0.9, 0.55}, kLensImage);
  // It reaches from 0.15 - e / 2 to 0.15 + 1.5 e: up to 0.6 of the neighbour that is e = 0.3, as to the border.
  EXPECT_NEAR(lensBox(layout.regions[0]).upper.x, 0.6, 2 * kSingleRounding);
  EXPECT_NEAR(layout.regions[0].extent.x, 0.3, kSingleRounding);
}

TEST(GpcLensEdit, aCornerDoesNotPassTheOppositeOne) {
  GpcLayout layout = twoLenses();
  dragLensCorner(layout, 0, LensCorner::kTopLeft, {0.9, 0.9}, kLensImage);
  EXPECT_NEAR(layout.regions[0].extent.x, kMinLensExtent, kSingleRounding);
  EXPECT_NEAR(cornerOf(layout.regions[0], LensCorner::kBottomRight).x, 0.25, kSingleRounding);
}

TEST(GpcLensEdit, aTransitionWidensUpToItsNeighbourAlongOneAxis) {
  GpcLayout layout = twoLenses();
  layout.regions[0].center.x = 0.45f;  // [0.35, 0.55]
  widenLens(layout, 0, 10);
  EXPECT_NEAR(lensBox(layout.regions[0]).upper.x, 0.6, 1e-6);
  layout = twoLenses();
  layout.regions[0].center.y = 0.2f;  // above the neighbour: the border of the image is nearer
  widenLens(layout, 0, 10);
  EXPECT_NEAR(lensBox(layout.regions[0]).lower.y, 0, 1e-6);
  EXPECT_NEAR(layout.regions[0].transitionWidth, 3, 1e-5);
}

TEST(GpcLensEdit, zoomsBelowOneStopWhereTheyWouldFold) {
  GpcLayout layout = twoLenses();
  setLensSampling(layout, *findGpcSampling("quadratic"));
  zoomLens(layout, 0, 0.1);
  EXPECT_NEAR(layout.regions[0].zoom, 0.75, 1e-6) << "(outer + 1) / (2 outer) with outer = 2";
  EXPECT_TRUE(isValid(layout));
  zoomLens(layout, 0, 1000);
  EXPECT_EQ(layout.regions[0].zoom, 64);
  // And a transition stops narrowing there.
  zoomLens(layout, 0, 0.8);
  widenLens(layout, 0, 0);
  EXPECT_NEAR(layout.regions[0].outer(), 1 / 0.6, 1e-6) << "0.8 = (outer + 1) / (2 outer)";
  EXPECT_TRUE(isValid(layout));
}

TEST(GpcLensEdit, anotherSamplingRaisesTheZoomsThatItWouldFold) {
  GpcLayout layout = twoLenses();
  layout.sampling = findGpcSampling("linear");
  layout.regions[0].zoom = 0.6f;  // linear takes more than 1 / outer = 0.5
  setLensSampling(layout, *findGpcSampling("quadratic"));
  EXPECT_NEAR(layout.regions[0].zoom, 0.75, 1e-6);
  EXPECT_EQ(layout.regions[1].zoom, 3);
  EXPECT_TRUE(isValid(layout));
}

TEST(GpcLensEdit, anAddedLensShowsThePlaceThatWasAsked) {
  GpcLayout layout = twoLenses();
  GpcRegion wanted{{0.45f, 0.5f}, {0.1f, 0.1f}, 4, 0.5f};
  EXPECT_EQ(addLens(layout, wanted, kLensImage), 2U);
  EXPECT_EQ(layout.regions[2], wanted);
  // Between a neighbour and itself there is room for a smaller one alone.
  wanted.center = {0.33f, 0.5f};
  ASSERT_EQ(addLens(layout, wanted, kLensImage), 3U);
  EXPECT_LT(layout.regions[3].extent.x, 0.1f);
  EXPECT_TRUE(isValid(layout));
  // Within another lens there is none.
  wanted.center = {0.2f, 0.5f};
  EXPECT_EQ(addLens(layout, wanted, kLensImage), std::nullopt);
  EXPECT_EQ(layout.regions.size(), 4U);
}

TEST(GpcLensEdit, thereAreNoMoreLensesThanALayoutHolds) {
  GpcLayout layout;
  layout.regions.clear();
  for (size_t i = 0; i < GpcLayout::kMaxRegions; ++i) {
    const GpcRegion lens{
        {(static_cast<float>(i % 16) + 0.5f) / 17, (static_cast<float>(i / 16) + 0.5f) / 17}, {0.02f, 0.02f}, 2, 0.5f};
    ASSERT_EQ(addLens(layout, lens, kLensImage), i);
  }
  EXPECT_EQ(addLens(layout, {{0.98f, 0.98f}, {0.02f, 0.02f}, 2, 0.5f}, kLensImage), std::nullopt);
  EXPECT_TRUE(isValid(layout));
}

TEST(GpcLensEdit, random20000EditsNeverGiveAnInvalidLayout) {
  constexpr int kLayouts = 100;
  constexpr int kEdits = 200;
  RandomLenses random(1);
  size_t lensesAtMost = 0;
  for (int i = 0; i < kLayouts; ++i) {
    GpcLayout layout = random.layout(1 + random.index(12));
    ASSERT_TRUE(isValid(layout));
    for (int edit = 0; edit < kEdits && !layout.regions.empty(); ++edit) {
      const size_t lens = random.index(layout.regions.size());
      const GpcLayout before = layout;
      switch (random.index(8)) {
        case 0:
        case 1:
          moveLens(layout, lens, random.place(), kLensImage);
          break;
        case 2:
        case 3:
          dragLensCorner(layout, lens, random.corner(), random.place(), kLensImage);
          break;
        case 4:
          sizeLens(layout, lens, random.place(), kLensImage);
          break;
        case 5:
          zoomLens(layout, lens, random.number(0, 70));
          break;
        case 6:
          widenLens(layout, lens, random.number(-1, 5));
          break;
        case 7:
          setLensSampling(layout, random.sampling());
          break;
      }
      ASSERT_TRUE(isValid(layout)) << jsonText(before) << "\nlens " << lens << "\n" << jsonText(layout);
      for (size_t k = 0; k < layout.regions.size(); ++k) {
        if (k != lens && layout.sampling == before.sampling) {
          ASSERT_EQ(layout.regions[k], before.regions[k]) << "the others stay";
        }
      }
    }
    lensesAtMost = std::max(lensesAtMost, layout.regions.size());
  }
  EXPECT_GT(lensesAtMost, 5U) << "there were neighbours to run into";
}

/// Valid places of a fine grid must not be nearer to the wanted one than where the lens went.
TEST(GpcLensEdit, noValidPlaceOfAGridIsNearerThanWhereALensGoes) {
  constexpr int kGridSteps = 60;
  RandomLenses random(2);
  int blocked = 0;
  for (int i = 0; i < 150; ++i) {
    GpcLayout layout = random.layout(8);
    const size_t lens = random.index(layout.regions.size());
    const glm::dvec2 wanted = random.place();
    GpcLayout tried = layout;
    moveLens(layout, lens, wanted, kLensImage);
    const double distance = pixelsBetween(glm::dvec2(layout.regions[lens].center), wanted);
    blocked += distance > 1;
    for (int y = 0; y <= kGridSteps; ++y) {
      for (int x = 0; x <= kGridSteps; ++x) {
        tried.regions[lens].center = glm::vec2(x, y) / static_cast<float>(kGridSteps);
        if (pixelsBetween(glm::dvec2(tried.regions[lens].center), wanted) < distance - 1e-2) {
          ASSERT_FALSE(isValid(tried)) << jsonText(tried) << "\nlens " << lens << " wanted at " << wanted.x << ", "
                                       << wanted.y;
        }
      }
    }
  }
  EXPECT_GT(blocked, 50);
}

/// The same of a corner, and of both extents.
TEST(GpcLensEdit, noValidExtentOfAGridIsNearerThanThatOfALens) {
  constexpr int kGridSteps = 60;
  RandomLenses random(3);
  int blocked = 0;
  for (int i = 0; i < 150; ++i) {
    const GpcLayout start = random.layout(8);
    const size_t lens = random.index(start.regions.size());
    const LensCorner corner = random.corner();
    const auto opposite = static_cast<LensCorner>(3 - static_cast<int>(corner));
    const glm::dvec2 fixed = cornerOf(start.regions[lens], opposite);
    const glm::dvec2 wanted = random.place();
    GpcLayout layout = start;
    dragLensCorner(layout, lens, corner, wanted, kLensImage);
    const double distance = pixelsBetween(cornerOf(layout.regions[lens], corner), wanted);
    const glm::dvec2 drift = (cornerOf(layout.regions[lens], opposite) - fixed) * kLensImage;
    EXPECT_LT(glm::length(drift), 1e-3) << "pixels: the opposite corner stays";
    blocked += distance > 1;
    const glm::dvec2 way = (cornerOf(start.regions[lens], corner) - fixed) / glm::dvec2(start.regions[lens].extent);
    GpcLayout tried = start;
    for (int y = 1; y <= kGridSteps; ++y) {
      for (int x = 1; x <= kGridSteps; ++x) {
        const glm::dvec2 extent = glm::dvec2(x, y) / static_cast<double>(kGridSteps);
        tried.regions[lens].extent = glm::vec2(extent);
        tried.regions[lens].center = glm::vec2(fixed + way * extent / 2.0);
        if (pixelsBetween(fixed + way * extent, wanted) < distance - 1e-2) {
          ASSERT_FALSE(isValid(tried)) << jsonText(tried);
        }
      }
    }
  }
  EXPECT_GT(blocked, 50);
}

/// A little more than the width that a lens got does not fit, where that was less than wanted.
TEST(GpcLensEdit, aTransitionGetsAllTheWidthThatThereIs) {
  RandomLenses random(4);
  int blocked = 0;
  for (int i = 0; i < 500; ++i) {
    GpcLayout layout = random.layout(6);
    const size_t lens = random.index(layout.regions.size());
    const double wanted = random.number(0.01, 6);
    widenLens(layout, lens, wanted);
    const auto got = static_cast<double>(layout.regions[lens].transitionWidth);
    if (got < wanted - 1e-4) {
      ++blocked;
      // By more than 1e-6 of the image, which validate() lets pass.
      layout.regions[lens].transitionWidth +=
          4e-6f / std::min(layout.regions[lens].extent.x, layout.regions[lens].extent.y) + 1e-5f;
      EXPECT_FALSE(isValid(layout)) << jsonText(layout);
    }
  }
  EXPECT_GT(blocked, 50);
}

}  // namespace
}  // namespace ocelli
