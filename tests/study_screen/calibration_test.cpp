#include "study/screen/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Step = CalibrationSteps::Step;

constexpr CalibratedScreen kScreen{1920, 1200, 518, 600};

TEST(Calibration, theCardGivesTheSize) {
  CalibrationSteps steps({.card = true}, kScreen);
  EXPECT_EQ(steps.step(), Step::kCard);
  // A screen of 480 mm with 4 pixels a millimetre: the card is 342.4 pixels wide.
  for (int i = 0; i < 400 && steps.cardPixels().x < 342; ++i) {
    steps.press(steps.cardPixels().x < 330 ? Key::kUp : Key::kRight, 0);
  }
  for (int i = 0; i < 400 && steps.cardPixels().x > 342; ++i) {
    steps.press(Key::kLeft, 0);
  }
  EXPECT_NEAR(steps.cardPixels().x / steps.cardPixels().y, 85.60 / 53.98, 1e-12);
  steps.press(Key::kEnter, 0);
  EXPECT_EQ(steps.step(), Step::kDone);
  ASSERT_TRUE(steps.result().pixelsPerMillimeter.has_value());
  EXPECT_NEAR(*steps.result().pixelsPerMillimeter, 4, 0.006);  // half a pixel of 342
  EXPECT_FALSE(steps.result().distanceMillimeters.has_value());
}

TEST(Calibration, theCardStaysOnTheScreen) {
  CalibrationSteps steps({.card = true}, kScreen);
  for (int i = 0; i < 400; ++i) {
    steps.press(Key::kUp, 0);
  }
  EXPECT_LE(steps.cardPixels().x, kScreen.width);
  EXPECT_LE(steps.cardPixels().y, kScreen.height);
  for (int i = 0; i < 800; ++i) {
    steps.press(Key::kDown, 0);
  }
  EXPECT_GT(steps.cardPixels().x, 10);
}

TEST(Calibration, aTapeGivesTheDistance) {
  CalibrationSteps steps({.card = false, .distance = DistanceMeasure::kTape}, kScreen);
  ASSERT_EQ(steps.step(), Step::kTape);
  steps.press(Key::kEnter, 0);
  EXPECT_EQ(steps.step(), Step::kTape) << "nothing was typed";
  for (const Key key : {Key::k5, Key::k8}) {
    steps.press(key, 0);
  }
  steps.press(Key::kEnter, 0);
  EXPECT_EQ(steps.step(), Step::kTape) << "58 mm is no distance";
  for (const Key key : {Key::k7, Key::k9, Key::k9, Key::kBackspace, Key::kBackspace, Key::k5}) {
    steps.press(key, 0);
  }
  EXPECT_EQ(steps.typed(), "585");
  steps.press(Key::kEnter, 0);
  EXPECT_EQ(steps.step(), Step::kDone);
  EXPECT_EQ(steps.result().distanceMillimeters, 585);
}

/// Someone at that distance, whose blind spot is 13.5 degrees aside, and who presses `late` seconds after the disc
/// vanished.
ScreenCalibration byBlindSpot(double distance, double late) {
  const double pixelsPerMillimeter = kScreen.width / kScreen.widthMillimeters;
  CalibrationSteps steps({.card = false, .distance = DistanceMeasure::kBlindSpot}, kScreen);
  double now = 10;
  for (int i = 0; i < steps.wanted(); ++i) {
    EXPECT_FALSE(steps.disc(now).has_value());
    steps.press(Key::kSpace, now);
    const double blind = steps.cross().x - distance * std::tan(radiansFromDegrees(13.5)) * pixelsPerMillimeter;
    while (steps.disc(now)->x > blind) {
      now += 0.001;
    }
    now += late;
    steps.press(Key::kSpace, now);
    now += 1;
  }
  EXPECT_EQ(steps.step(), Step::kDone);
  return steps.result();
}

TEST(Calibration, theBlindSpotGivesTheDistance) {
  for (const double distance : {450.0, 600.0, 750.0}) {
    const ScreenCalibration measured = byBlindSpot(distance, 0);
    ASSERT_TRUE(measured.distanceMillimeters.has_value());
    EXPECT_NEAR(*measured.distanceMillimeters, distance, 1);  // steps of the test are 0.015 mm of disc
    EXPECT_NEAR(*measured.distanceSpread, 0, 1e-3);
    // A reaction of 0.3 s makes it 4.5 mm / tan(13.5 degrees) longer.
    EXPECT_NEAR(*byBlindSpot(distance, 0.3).distanceMillimeters, distance + 4.5 / std::tan(radiansFromDegrees(13.5)),
                1);
  }
}

TEST(Calibration, aDiscThatDoesNotVanishStartsAgain) {
  CalibrationSteps steps({.card = false, .distance = DistanceMeasure::kBlindSpot}, kScreen);
  steps.press(Key::kSpace, 0);
  EXPECT_FALSE(steps.ranOut(1));
  EXPECT_TRUE(steps.ranOut(1000));
  steps.press(Key::kSpace, 1000);
  EXPECT_EQ(steps.measured(), 0);
  EXPECT_FALSE(steps.ranOut(1001));
}

TEST(Calibration, tellsWhatIsOffFromTheProtocol) {
  const double pixelsPerMillimeter = 1920 / 518.0;
  EXPECT_THAT(deviationsOf({pixelsPerMillimeter * 1.04, 620, {}}, kScreen, 0.05), IsEmpty());
  EXPECT_THAT(deviationsOf({}, kScreen, 0.05), IsEmpty());
  EXPECT_THAT(deviationsOf({pixelsPerMillimeter / 1.1, 540, {}}, kScreen, 0.05),
              ElementsAre(HasSubstr("width is 570 mm, but the protocol states 518 mm (+10.0 %)"),
                          HasSubstr("eye is 540 mm, but the protocol states 600 mm (-10.0 %)")));
}

TEST(Calibration, aPixelInTheMiddleHasItsDegrees) {
  // 1 mm at 57.3 cm is 0.1 degrees.
  EXPECT_NEAR(degreesPerPixel(1, 573), 0.1, 1e-4);
  EXPECT_THAT(describe({4, 573, {}}, kScreen), HasSubstr("40.0 pixels a degree"));
}

TEST(Calibration, isStoredWithWhatWasNotMeasured) {
  const nlohmann::json json =
      nlohmann::json::parse(ScreenCalibration{4, {}, {}}.jsonText({true, DistanceMeasure::kStated, 0.05}));
  EXPECT_EQ(json.at("pixels_per_millimeter"), 4.0);
  EXPECT_TRUE(json.at("distance_millimeters").is_null());
  EXPECT_EQ(json.at("distance"), "stated");
}

}  // namespace
}  // namespace ocelli
