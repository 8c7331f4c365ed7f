#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "oc_core/base/error.h"
#include "oc_core/focus/fisheye_focus.h"
#include "tests/focus/focus_layouts.h"

namespace ocelli {
namespace {

using test::focusWay;
using test::kFocusSize;
using test::twoFoci;

TEST(FocusWays, eachFindsAgainWhatItShows) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (const FocusWay& way : focusWays()) {
    const auto map = way.map(twoFoci(), kFocusSize);
    for (int i = 0; i < 10000; ++i) {
      const glm::dvec2 at = glm::dvec2(share(random), share(random)) * glm::dvec2(kFocusSize);
      const auto found = map->pictureFromPlain(map->plainFromPicture(at));
      ASSERT_TRUE(found) << way.name;
      EXPECT_LT(glm::length(*found - at), 1e-8) << way.name << " at " << at.x << ", " << at.y;
    }
  }
}

TEST(FocusWays, eachShowsTheMiddleOfAFocusInItsPlaceAndTheCornersOfTheImageInTheirs) {
  for (const FocusWay& way : focusWays()) {
    const auto map = way.map(twoFoci(), kFocusSize);
    for (const FocusBox& box : focusPlaces(twoFoci(), kFocusSize)) {
      EXPECT_LT(glm::length(map->plainFromPicture(box.center) - box.center), 1e-9) << way.name;
    }
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(320, 240)}) {
      EXPECT_EQ(map->plainFromPicture(corner), corner) << way.name;
    }
  }
}

TEST(FocusWays, allThatZoomShowAFocusAsLargeAlongTheAxes) {
  const std::vector<FocusBox> places = focusPlaces(twoFoci(), kFocusSize);
  const std::vector<FocusBox> contents = focusContents(twoFoci(), kFocusSize);
  EXPECT_NEAR(contents[1].half.x, places[1].half.x / 6, 1e-12);
  for (const char* name : {"gpc", "fisheye", "inset"}) {
    const auto map = focusWay(name).map(twoFoci(), kFocusSize);
    for (size_t i = 0; i < places.size(); ++i) {
      for (int axis = 0; axis < 2; ++axis) {
        glm::dvec2 edge = contents[i].center;
        edge[axis] += contents[i].half[axis] * (1 - 1e-12);
        EXPECT_NEAR((*map->pictureFromPlain(edge))[axis], places[i].center[axis] + places[i].half[axis], 1e-8) << name;
      }
    }
  }
}

TEST(FocusWays, theFisheyeIsThatOfSarkarAndBrown) {
  // g(x) = (d + 1) x / (d x + 1), with x in shares of the half axes of the ellipse.
  const double zoom = 3;
  const double outer = 1 + static_cast<double>(0.8f);
  const double d = fisheyeDistortion(zoom, outer);
  EXPECT_NEAR(d, 4.5, 1e-6) << "2 * 1.8 / 0.8";
  const auto map = focusWay("fisheye").map(twoFoci(), kFocusSize);
  const FocusBox place = focusPlaces(twoFoci(), kFocusSize)[0];
  const glm::dvec2 way = glm::normalize(glm::dvec2(1, 2)) * place.half * outer;
  for (const double x : {0.01, 0.2, 0.5, 0.9}) {
    const double g = (d + 1) * x / (d * x + 1);
    EXPECT_LT(glm::length(*map->pictureFromPlain(place.center + way * x) - (place.center + way * g)), 1e-9);
    EXPECT_LT(glm::length(map->plainFromPicture(place.center + way * g) - (place.center + way * x)), 1e-9);
  }
}

TEST(FocusWays, theInsetCoversWhatLiesAroundTheFocus) {
  const auto map = focusWay("inset").map(twoFoci(), kFocusSize);
  const FocusBox place = focusPlaces(twoFoci(), kFocusSize)[0];
  EXPECT_EQ(map->pictureFromPlain(place.center + place.half * 0.9), std::nullopt);
  EXPECT_TRUE(map->pictureFromPlain(place.center + place.half * 0.3));
  EXPECT_TRUE(map->pictureFromPlain(place.center + place.half * 1.1));
}

TEST(FocusWays, whatIsNoFocusIsRefused) {
  GpcLayout layout = twoFoci();
  EXPECT_NO_THROW(requireFoci(layout, "test"));
  layout.regions[1].zoom = 1;
  try {
    requireFoci(layout, "test");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("region 2"), std::string::npos);
  }
  layout.regions.clear();
  EXPECT_THROW(requireFoci(layout, "test"), InputError);
}

}  // namespace
}  // namespace ocelli
