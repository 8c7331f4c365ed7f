#include "oc_core/camera/gpc_lens_hit.h"

#include <gtest/gtest.h>

#include "tests/camera/random_lenses.h"

namespace ocelli {
namespace {

using test::kLensImage;
using test::RandomLenses;

constexpr double kReach = 6;

/// One lens whose region is 384 x 144 pixels around the middle of the image, and twice that with its transition.
GpcLayout oneLens() {
  return {findGpcSampling("cubic"), {{{0.5f, 0.5f}, {0.3f, 0.2f}, 3, 1}}};
}

std::optional<LensHit> hitAtPixel(const GpcLayout& layout, double x, double y) {
  return lensHitAt(layout, glm::dvec2(x, y) / kLensImage, kReach, kLensImage);
}

TEST(GpcLensHit, tellsThePartsOfALensApart) {
  const GpcLayout layout = oneLens();
  EXPECT_EQ(hitAtPixel(layout, 640, 360), (LensHit{0, LensPart::kInside}));
  EXPECT_EQ(hitAtPixel(layout, 640, 250), (LensHit{0, LensPart::kInside})) << "its transition";
  EXPECT_EQ(hitAtPixel(layout, 448, 288), (LensHit{0, LensPart::kCorner, LensCorner::kTopLeft}));
  EXPECT_EQ(hitAtPixel(layout, 836, 436), (LensHit{0, LensPart::kCorner, LensCorner::kBottomRight}));
  EXPECT_EQ(hitAtPixel(layout, 640, 216), (LensHit{0, LensPart::kOuterEdge}));
  EXPECT_EQ(hitAtPixel(layout, 640, 212), (LensHit{0, LensPart::kOuterEdge})) << "from outside, too";
  EXPECT_EQ(hitAtPixel(layout, 640, 208), std::nullopt);
}

TEST(GpcLensHit, aSmallLensHasAPartThatMovesIt) {
  GpcLayout layout = oneLens();
  layout.regions[0].extent = {0.005f, 0.005f};  // 6.4 x 3.6 pixels
  EXPECT_EQ(hitAtPixel(layout, 640, 360), (LensHit{0, LensPart::kInside}));
}

TEST(GpcLensHit, ofTwoThatTouchTheOneThatHoldsThePlaceIsMet) {
  const GpcLayout layout{findGpcSampling("cubic"),
                         {{{0.25f, 0.5f}, {0.25f, 0.25f}, 3, 1}, {{0.75f, 0.5f}, {0.25f, 0.25f}, 3, 1}}};
  EXPECT_EQ(hitAtPixel(layout, 638, 360), (LensHit{0, LensPart::kOuterEdge}));
  EXPECT_EQ(hitAtPixel(layout, 642, 360), (LensHit{1, LensPart::kOuterEdge}));
}

TEST(GpcLensHit, aDragKeepsHoldOfWhereItBegan) {
  const glm::dvec2 begin = glm::dvec2(600, 340) / kLensImage;
  const LensDrag drag(oneLens(), {0, LensPart::kInside}, begin, kLensImage);
  EXPECT_EQ(drag.layoutAt(begin), oneLens());
  const GpcRegion moved = drag.layoutAt(begin + glm::dvec2(0.1, -0.05)).regions[0];
  EXPECT_NEAR(moved.center.x, 0.6, 1e-7);
  EXPECT_NEAR(moved.center.y, 0.45, 1e-7);
}

TEST(GpcLensHit, draggingTheOuterEdgeChangesTheTransitionAlone) {
  const glm::dvec2 begin = glm::dvec2(640, 214) / kLensImage;  // two pixels outside
  const LensDrag drag(oneLens(), {0, LensPart::kOuterEdge}, begin, kLensImage);
  GpcRegion expected = oneLens().regions[0];
  // 36 pixels inward are half of half the height of the region.
  const GpcRegion narrowed = drag.layoutAt(begin + glm::dvec2(0, 36) / kLensImage).regions[0];
  EXPECT_NEAR(narrowed.transitionWidth, 0.5, 1e-6);
  expected.transitionWidth = narrowed.transitionWidth;
  EXPECT_EQ(narrowed, expected);
}

TEST(GpcLensHit, aDragGivesTheSameWhateverWayThePointerTook) {
  RandomLenses random(5);
  for (int i = 0; i < 300; ++i) {
    const GpcLayout layout = random.layout(6);
    const glm::dvec2 begin(random.number(0, 1), random.number(0, 1));
    const auto hit = lensHitAt(layout, begin, kReach, kLensImage);
    if (!hit) {
      continue;
    }
    const glm::dvec2 end = random.place();
    const LensDrag direct(layout, *hit, begin, kLensImage);
    const LensDrag wandering(layout, *hit, begin, kLensImage);
    for (int step = 0; step < 5; ++step) {
      validate(wandering.layoutAt(random.place()), "on the way");
    }
    EXPECT_EQ(wandering.layoutAt(end), direct.layoutAt(end));
  }
}

}  // namespace
}  // namespace ocelli
