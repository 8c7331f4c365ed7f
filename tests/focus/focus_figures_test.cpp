#include "oc_core/focus/focus_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "oc_core/focus/fisheye_focus.h"
#include "oc_core/multiperspective/rate_figure.h"
#include "tests/focus/focus_layouts.h"

namespace ocelli {
namespace {

using test::focusWay;
using test::kFocusSize;
using test::squareFocus;
using test::twoFoci;

/// Coordinates up to 320 are rounded by 6e-14, differences are over 2e-4, and a rate of 4 is the square of that
/// above 1.
constexpr double kRateRounding = 1e-8;

FocusFigures figuresOf(const char* way, const GpcLayout& layout) {
  return focusFigures(*focusWay(way).map(layout, kFocusSize), layout, kFocusSize);
}

TEST(FocusFigures, thePlainViewLosesNothingAndZoomsNothing) {
  const FocusFigures figures = figuresOf("plain", squareFocus());
  // The focus is 20 x 20 pixels large.
  EXPECT_DOUBLE_EQ(figures.focusShare, 400.0 / (320 * 240));
  EXPECT_NEAR(figures.leastFocusRate.value(), 1, kRateRounding);
  EXPECT_NEAR(figures.greatestFocusRate.value(), 1, kRateRounding);
  EXPECT_NEAR(figures.leastContextRate.value(), 1, kRateRounding);
  EXPECT_NEAR(figures.focusBend, 0, 1e-12);
  EXPECT_NEAR(figures.contextBend, 0, 1e-12);
  EXPECT_EQ(figures.hiddenShare, 0);
  EXPECT_EQ(figures.sparseShare, 0);
  EXPECT_TRUE(figures.isContinuous());
  EXPECT_NEAR(figures.rateStep, 1, 1e-9);
}

TEST(FocusFigures, anInsetHidesWhatItCoversAndJumpsAtItsBorder) {
  const FocusFigures figures = figuresOf("inset", squareFocus());
  EXPECT_DOUBLE_EQ(figures.focusShare, 6400.0 / (320 * 240));
  EXPECT_DOUBLE_EQ(figures.hiddenShare, (6400.0 - 400) / (320 * 240 - 400));
  EXPECT_DOUBLE_EQ(figures.sparseShare, figures.hiddenShare) << "all else is as in the plain view";
  EXPECT_NEAR(figures.leastFocusRate.value(), 4, kRateRounding);
  EXPECT_NEAR(figures.greatestFocusRate.value(), 4, kRateRounding);
  EXPECT_NEAR(figures.leastContextRate.value(), 1, kRateRounding);
  EXPECT_NEAR(figures.focusBend, 0, 1e-12);
  // A place of the border at (40, y) from the middle is beside what is seen at a quarter of that. The row that is
  // nearest to a corner and looked at is at most four pixels from it.
  EXPECT_LE(figures.jumpPixels, 0.75 * std::hypot(40, 40));
  EXPECT_GE(figures.jumpPixels, 0.75 * std::hypot(40, 36));
  EXPECT_NEAR(figures.rateStep, 4, 1e-6);
}

TEST(FocusFigures, aGeneralPinholesFocusIsUndistortedAndNothingIsHidden) {
  for (const char* sampling : {"linear", "quadratic", "cubic"}) {
    const FocusFigures figures = figuresOf("gpc", squareFocus(sampling));
    EXPECT_DOUBLE_EQ(figures.focusShare, 6400.0 / (320 * 240)) << sampling;
    EXPECT_NEAR(figures.leastFocusRate.value(), 4, kRateRounding) << sampling;
    EXPECT_NEAR(figures.greatestFocusRate.value(), 4, kRateRounding) << sampling;
    EXPECT_NEAR(figures.focusBend, 0, 1e-12) << sampling;
    EXPECT_EQ(figures.hiddenShare, 0) << sampling;
    EXPECT_TRUE(figures.isContinuous()) << sampling << " " << figures.jumpPixels;
    EXPECT_GT(figures.contextBend, 0.05) << sampling << ": the transition pays for it";
  }
}

TEST(FocusFigures, onlyTheCubicsRateIsContinuous) {
  // With a square region it is so across the diagonals too; a place is told from its neighbour over 1/256 of a pixel,
  // across which the rate of the cubic changes by some thousandths.
  EXPECT_NEAR(figuresOf("gpc", squareFocus("cubic")).rateStep, 1, 0.02);
  EXPECT_GT(figuresOf("gpc", squareFocus("quadratic")).rateStep, 1.5) << "at the outer edge";
  EXPECT_GT(figuresOf("gpc", squareFocus("linear")).rateStep, 4) << "at the inner edge, from 4 to less than 1";
}

TEST(FocusFigures, theLeastRateIsThatOfCameraShow) {
  for (const GpcLayout& layout : {squareFocus(), squareFocus("linear"), twoFoci()}) {
    const RateSummary summary = summarizeRates(GpcCamera(PinholeCamera(View{}, kFocusSize.x, kFocusSize.y), layout));
    // That is from derivatives at the same places, with the exact least rate along the axes among them.
    EXPECT_NEAR(figuresOf("gpc", layout).leastContextRate.value(), summary.leastAnywhere, 0.01 * summary.leastAnywhere);
  }
}

TEST(FocusFigures, aFisheyeBendsItsFocusAndZoomsItUnevenly) {
  const FocusFigures figures = figuresOf("fisheye", squareFocus());
  EXPECT_EQ(figures.hiddenShare, 0);
  EXPECT_TRUE(figures.isContinuous());
  EXPECT_GT(figures.focusBend, 0.05);
  // Pixels around the middle have nearly the zoom there, d + 1 = 7.
  EXPECT_NEAR(figures.greatestFocusRate.value(), fisheyeDistortion(4, 2) + 1, 0.3);
  // At the corner of the focus, at x = sqrt(2) / 8 of the border: g' = (d + 1) / (d x + 1)^2 = 1.65.
  EXPECT_NEAR(figures.leastFocusRate.value(), 7 / std::pow(6 * std::sqrt(2.0) / 8 + 1, 2), 0.1);
  // At the border g' = 1 / (d + 1).
  EXPECT_NEAR(figures.leastContextRate.value(), 1.0 / 7, 0.01);
  EXPECT_NEAR(figures.rateStep, 7, 0.1);
}

TEST(FocusFigures, theMostExtremeLensHasFiguresToo) {
  GpcLayout layout = squareFocus();
  layout.regions[0].zoom = 64;
  layout.regions[0].transitionWidth = 0.01f;
  for (const FocusWay& way : focusWays()) {
    const FocusFigures figures = focusFigures(*way.map(layout, kFocusSize), layout, kFocusSize);
    for (const double value :
         {figures.leastFocusRate.value(), figures.greatestFocusRate.value(), figures.leastContextRate.value(),
          figures.focusBend, figures.contextBend, figures.jumpPixels, figures.rateStep}) {
      EXPECT_TRUE(std::isfinite(value)) << way.name;
    }
    EXPECT_GT(figures.leastContextRate.value(), 0) << way.name;
  }
}

TEST(FocusFigures, aFocusBetweenPixelCentresHasNoRate) {
  GpcLayout layout = squareFocus();
  layout.regions[0].extent = {2.8f / 320, 2.8f / 240};  // around the corner of four pixels, a quarter of it in focus
  const FocusFigures plain = focusFigures(*focusWay("plain").map(layout, kFocusSize), layout, kFocusSize);
  EXPECT_EQ(plain.focusShare, 0);
  EXPECT_EQ(plain.leastFocusRate, std::nullopt);
  EXPECT_EQ(plain.greatestFocusRate, std::nullopt);
  EXPECT_NEAR(plain.leastContextRate.value(), 1, kRateRounding);
  const FocusFigures gpc = focusFigures(*focusWay("gpc").map(layout, kFocusSize), layout, kFocusSize);
  EXPECT_DOUBLE_EQ(gpc.focusShare, 4.0 / (320 * 240));
  EXPECT_NEAR(gpc.leastFocusRate.value(), 4, kRateRounding);
}

/// The plain view, but for what is in focus, which is upside down.
class FlippedFocusMap final : public FocusMap {
 public:
  explicit FlippedFocusMap(const FocusBox& focus) : focus_(focus) {}
  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override {
    return focus_.contains(picture) ? glm::dvec2(picture.x, 2 * focus_.center.y - picture.y) : picture;
  }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override { return plainFromPicture(plain); }

 private:
  FocusBox focus_;
};

TEST(FocusFigures, aNarrowFocusIsNoContext) {
  GpcLayout layout = squareFocus();
  layout.regions[0].zoom = 64;  // 1.25 pixels are in focus, the segments are 30 pixels long
  const FlippedFocusMap map(focusContents(layout, kFocusSize).front());
  EXPECT_NEAR(focusFigures(map, layout, kFocusSize).contextBend, 0, 1e-12);
  GpcLayout elsewhere = layout;
  elsewhere.regions[0].center.x = 0.75f;
  // Half a pixel above its middle is shown half a pixel below.
  EXPECT_NEAR(focusFigures(map, elsewhere, kFocusSize).contextBend, 1.0 / 30, 1e-3);
}

/// What a picture shows of the plain view is the integral of its Jacobian's determinant: another way to the hidden
/// share, which takes no way's word for it.
TEST(FocusFigures, hiddenSharesAgreeWithTheAreasThatPicturesShow) {
  constexpr double kStep = 0.01;
  for (const FocusWay& way : focusWays()) {
    const GpcLayout layout = squareFocus();
    const auto map = way.map(layout, kFocusSize);
    double shown = 0;
    for (int y = 0; y < kFocusSize.y; ++y) {
      for (int x = 0; x < kFocusSize.x; ++x) {
        const glm::dvec2 at = glm::dvec2(x, y) + 0.5;
        const auto difference = [&](const glm::dvec2& by) {
          return (map->plainFromPicture(at + by) - map->plainFromPicture(at - by)) / (2 * kStep);
        };
        shown += std::abs(glm::determinant(glm::dmat2(difference({kStep, 0}), difference({0, kStep}))));
      }
    }
    const double pixels = kFocusSize.x * kFocusSize.y;
    const double hidden = focusFigures(*map, layout, kFocusSize).hiddenShare * (pixels - 400);
    EXPECT_NEAR(shown + hidden, pixels, 0.003 * pixels) << way.name << ": the sum over pixels is no integral";
  }
}

/// An inset that says it hides nothing.
class BoastfulMap final : public FocusMap {
 public:
  explicit BoastfulMap(std::unique_ptr<FocusMap> inset) : inset_(std::move(inset)) {}
  glm::dvec2 plainFromPicture(const glm::dvec2& picture) const override { return inset_->plainFromPicture(picture); }
  std::optional<glm::dvec2> pictureFromPlain(const glm::dvec2& plain) const override {
    return inset_->pictureFromPlain(plain).value_or(plain);
  }

 private:
  std::unique_ptr<FocusMap> inset_;
};

TEST(FocusFigures, aWayIsNotTakenAtItsWord) {
  const BoastfulMap map(focusWay("inset").map(squareFocus(), kFocusSize));
  EXPECT_EQ(focusFigures(map, squareFocus(), kFocusSize).hiddenShare, figuresOf("inset", squareFocus()).hiddenShare);
}

TEST(FocusFigures, ratesArePixelByPixel) {
  const auto map = focusWay("inset").map(squareFocus(), kFocusSize);
  const Image<float> picture = pictureRates(*map, kFocusSize);
  const Image<float> plain = plainRates(*map, kFocusSize);
  EXPECT_NEAR(picture(120, 120), 4, 1e-5);
  EXPECT_NEAR(picture(80, 100), 4, 1e-5) << "the first pixel of the inset";
  EXPECT_NEAR(picture(79, 100), 1, 1e-5) << "the last one beside";
  EXPECT_NEAR(plain(120, 120), 4, 1e-5);
  EXPECT_EQ(plain(100, 100), 0) << "covered";
  EXPECT_NEAR(plain(20, 20), 1, 1e-5);
}

}  // namespace
}  // namespace ocelli
