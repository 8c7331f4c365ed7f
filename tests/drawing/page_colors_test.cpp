#include "oc_core/page/page_colors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "oc_core/drawing/color_scale.h"
#include "oc_core/drawing/series_style.h"

namespace ocelli {
namespace {

/// As WCAG 2.1 defines it: black on white is 21.
double contrast(uint32_t one, uint32_t other) {
  // The inverse of CIE's lightness, whose dark end is straight.
  const auto luminance = [](uint32_t color) {
    const double lightness = labOf(paintOf(color)).lightness;
    return lightness > 8 ? std::pow((lightness + 16) / 116, 3) : lightness * std::pow(3.0 / 29, 3);
  };
  const double lower = std::min(luminance(one), luminance(other));
  return (std::max(luminance(one), luminance(other)) + 0.05) / (lower + 0.05);
}

TEST(PageColors, textStandsOutFromEachGround) {
  EXPECT_NEAR(contrast(0x000000, 0xffffff), 21, 0.01);
  for (uint32_t PageColor::*scheme : {&PageColor::light, &PageColor::dark, &PageColor::print}) {
    for (const PageColor& ground : {page_color::kGround, page_color::kCard, page_color::kTint}) {
      for (const PageColor& text : {page_color::kText, page_color::kSoft, page_color::kAccent, page_color::kCaution}) {
        EXPECT_GE(contrast(ground.*scheme, text.*scheme), 4.5) << text.name << " on " << ground.name;
      }
    }
  }
}

TEST(PageColors, seriesStandOutFromTheirGround) {
  // 3 : 1 is what WCAG 2.1 asks of graphics.
  for (size_t i = 0; i < 7; ++i) {
    for (const PageColor& color : page_color::kAll) {
      if (color.name == seriesStyle(i).colorName) {
        EXPECT_GE(contrast(page_color::kCard.light, color.light), 3) << color.name;
        EXPECT_GE(contrast(page_color::kCard.dark, color.dark), 3) << color.name;
      }
    }
  }
}

TEST(PageColors, aPageGetsEachOfThem) {
  const std::string style = pageColorsStyle(PageScheme::kFollowsScreen);
  for (const PageColor& color : page_color::kAll) {
    EXPECT_THAT(style, testing::HasSubstr("--" + std::string(color.name) + ": #"));
  }
  EXPECT_THAT(style, testing::HasSubstr("--text: #1c2126;"));
  EXPECT_THAT(style, testing::HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(pageColorsStyle(PageScheme::kLight), testing::Not(testing::HasSubstr("@media")));
  const std::string dark = pageColorsStyle(PageScheme::kDark);
  EXPECT_THAT(dark, testing::Not(testing::HasSubstr("@media")));
  EXPECT_THAT(dark, testing::HasSubstr("color-scheme: dark"));
  EXPECT_THAT(dark, testing::HasSubstr("--ground: #14171a;"));
}

TEST(SeriesStyle, sevenDifferInColourAndMarker) {
  std::set<std::string_view> colors;
  std::set<Marker> markers;
  for (size_t i = 0; i < 7; ++i) {
    colors.insert(seriesStyle(i).colorName);
    markers.insert(seriesStyle(i).marker);
  }
  EXPECT_EQ(colors.size(), 7U);
  EXPECT_EQ(markers.size(), 7U);
  EXPECT_EQ(seriesStyle(7).colorName, seriesStyle(0).colorName);
}

}  // namespace
}  // namespace ocelli
