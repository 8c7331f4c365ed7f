#include "display_sim/quilt/panel_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

// As displays have it, with fields that are of no meaning here.
constexpr const char* kCalibration = R"({
  "configVersion": "3.0", "serial": "LKG-TEST",
  "pitch": {"value": 52.5}, "slope": {"value": -7.2}, "center": {"value": 0.43}, "viewCone": {"value": 53.0},
  "DPI": {"value": 324.0}, "screenW": {"value": 12.0}, "screenH": {"value": 9.0}, "invView": {"value": 1.0},
  "flipImageX": {"value": 0.0}
})";

TEST(PanelOrder, readsTheCalibrationOfADisplay) {
  const PanelCalibration panel = calibrationFromJsonText(kCalibration, "visual.json");
  EXPECT_EQ(panel.pitch, 52.5);
  EXPECT_EQ(panel.slope, -7.2);
  EXPECT_EQ(panel.center, 0.43);
  EXPECT_EQ(panel.dotsPerInch, 324);
  EXPECT_EQ(panel.width, 12);
  EXPECT_EQ(panel.height, 9);
  EXPECT_EQ(panel.coneDegrees, 53);
  EXPECT_TRUE(panel.unused.empty());
}

TEST(PanelOrder, plainNumbersDoToo) {
  const PanelCalibration panel = calibrationFromJsonText(
      R"({"pitch": 50, "slope": 5, "center": 0, "DPI": 300, "screenW": 20, "screenH": 10, "flipImageX": 1})", "v");
  EXPECT_EQ(panel.pitch, 50);
  EXPECT_FALSE(panel.coneDegrees);
  EXPECT_THAT(panel.unused, testing::ElementsAre("\"flipImageX\": 1"));
}

TEST(PanelOrder, viewsInTheOtherOrderAreNotDone) {
  const PanelCalibration panel = calibrationFromJsonText(
      R"({"pitch": 50, "slope": 5, "center": 0, "DPI": 300, "screenW": 20, "screenH": 10, "invView": 0})", "v");
  EXPECT_THAT(panel.unused, testing::ElementsAre("\"invView\": 0"));
}

TEST(PanelOrder, theConeThatIsGivenGoesBeforeThatOfTheCalibration) {
  PanelCalibration panel = calibrationFromJsonText(kCalibration, "visual.json");
  const QuiltDisplay display = loadQuiltDisplay("portrait");
  EXPECT_EQ(withCone(display, panel, 30).coneDegrees, 30);
  EXPECT_EQ(withCone(display, panel, {}).coneDegrees, 53);
  EXPECT_EQ(withCone(display, {}, {}), display);
  panel.coneDegrees.reset();
  EXPECT_EQ(withCone(display, panel, {}), display);
  EXPECT_THROW(withCone(display, panel, 500), InputError);
}

TEST(PanelOrder, wrongCalibrationsAreNamed) {
  const auto message = [](const std::string& text) {
    try {
      calibrationFromJsonText(text, "visual.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message("[]"), testing::HasSubstr("visual.json"));
  EXPECT_THAT(message(R"({"pitch": 50})"), testing::HasSubstr("slope"));
  EXPECT_THAT(message(R"({"pitch": {"value": "x"}})"), testing::HasSubstr("pitch"));
  EXPECT_THAT(message(R"({"pitch": 50, "slope": 0, "center": 0, "DPI": 300, "screenW": 20, "screenH": 10})"),
              testing::HasSubstr("slope"));
}

TEST(PanelOrder, everyDotShowsTheViewOfTheFormula) {
  const PanelCalibration panel = calibrationFromJsonText(kCalibration, "visual.json");
  const QuiltDisplay display{"d", 4, 3, 40, 30, 1, 53};
  // Each tile of one grey that tells its number.
  Image<Rgb8> quilt(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const int view = (29 - y) / 10 * 4 + x / 10;
      quilt(x, y) = Rgb8(static_cast<uint8_t>(20 * view));
    }
  }
  const Image<Rgb8> picture = panelPicture(quilt, display, panel);
  ASSERT_EQ(picture.width(), 12);
  ASSERT_EQ(picture.height(), 9);
  for (int row = 0; row < 9; ++row) {
    for (int column = 0; column < 12; ++column) {
      const double x = (column + 0.5) / 12;
      const double y = 1 - (row + 0.5) / 9;  // upwards
      for (int i = 0; i < 3; ++i) {
        const double place =
            (x + i / (3 * 12.0) + y * 9.0 / (12.0 * -7.2)) * 52.5 * 12.0 / 324.0 * std::cos(std::atan(1 / -7.2)) - 0.43;
        const double view = 1 - (place - std::floor(place));
        EXPECT_EQ(picture(column, row)[i], 20 * std::min(11, static_cast<int>(view * 12))) << column << " " << row;
      }
    }
  }
}

TEST(PanelOrder, aDotTakesItsPlaceInTheTile) {
  // A ramp from left to right and from top to bottom, the same in both views: the panel shows it, whatever the view.
  const QuiltDisplay display{"d", 2, 1, 40, 10, 1, 40};
  Image<Rgb8> quilt(40, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 40; ++x) {
      quilt(x, y) = Rgb8(static_cast<uint8_t>(10 * (x % 20)), static_cast<uint8_t>(20 * y), 0);
    }
  }
  const PanelCalibration panel{20, 5, 0.1, 300, 20, 10};
  const Image<Rgb8> picture = panelPicture(quilt, display, panel);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(picture(x, y), Rgb8(10 * x, 20 * y, 0));
    }
  }
}

}  // namespace
}  // namespace ocelli
