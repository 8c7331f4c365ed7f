// How large a screen is and how far from the eye, measured before a session where the protocol asks for it
// ("calibration" in "screen"): the first with a card of known size held against the screen, the second by the blind
// spot or with a tape. What is shown in degrees of visual angle depends on both.
//
//   Li, Joo, Yeatman and Reinecke 2020   "Controlling for participants' viewing distance in large-scale, psychophysical
//                                        online experiments using a virtual chinrest": the blind spot lies 13.5 degrees
//                                        to the side; card and blind spot together find the distance
//   ISO/IEC 7810, ID-1                   cards of banks: 85.60 mm wide, 53.98 mm high
//
// No drawing here (calibration_drawing.h): keys and times go in, and what is to be shown comes out.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/input_event.h"
#include "study/outline/screen_fields.h"

namespace ocelli {

inline constexpr double kCardWidthMillimeters = 85.60;
inline constexpr double kCardHeightMillimeters = 53.98;
inline constexpr double kBlindSpotDegrees = 13.5;
/// Distances that may be typed.
inline constexpr int kMinTapeMillimeters = 100;
inline constexpr int kMaxTapeMillimeters = 5000;

/// What was measured; empty where it was not.
struct ScreenCalibration {
  std::optional<double> pixelsPerMillimeter{};
  std::optional<double> distanceMillimeters{};
  /// Of the single distances, their standard deviation over their mean; by the blind spot alone.
  std::optional<double> distanceSpread{};

  /// For the database, with the wishes that led to it.
  std::string jsonText(const CalibrationWishes& wishes) const;
};

/// From the eye to the screen, where the blind spot is so many millimetres aside of the fixated point.
double distanceFromBlindSpot(double millimetersAside);

/// What a session's screen has.
struct CalibratedScreen {
  int width = 0;  ///< pixels
  int height = 0;
  double widthMillimeters = 0;  ///< as the protocol states it
  double distanceMillimeters = 0;
};

/// Side of a pixel in the middle of the screen, degrees of visual angle.
double degreesPerPixel(double pixelsPerMillimeter, double distanceMillimeters);

/// A sentence for each measure that is off from what the protocol states by more than the tolerance.
std::vector<std::string> deviationsOf(const ScreenCalibration& measured, const CalibratedScreen& stated,
                                      double tolerance);

/// "38.6 pixels a centimetre, 603 mm from the eye, 41.2 pixels a degree"; what was not measured is as it is stated.
std::string describe(const ScreenCalibration& measured, const CalibratedScreen& stated);

class CalibrationSteps {
 public:
  enum class Step { kCard, kTape, kBlindSpot, kDone };

  CalibrationSteps(const CalibrationWishes& wishes, const CalibratedScreen& screen);

  Step step() const { return step_; }
  /// Keys that are pressed, repeats included, `seconds` after any moment that is the same for all calls.
  void press(Key key, double seconds);
  /// A button by which the mouse changes the size of the card, pixels.
  void widenCard(double pixels);

  const CalibratedScreen& screen() const { return screen_; }
  /// kCard: how large it is shown, pixels.
  glm::dvec2 cardPixels() const;
  /// kTape: what was typed so far, millimetres.
  const std::string& typed() const { return typed_; }
  /// Whether what was typed can be a distance: 100 to 5000 mm.
  bool typedIsPossible() const;

  // kBlindSpot.
  /// The cross to look at with the left eye, pixels.
  glm::dvec2 cross() const;
  /// The disc that moves to the left of it, where it is `seconds`, pixels; nothing before it starts.
  std::optional<glm::dvec2> disc(double seconds) const;
  int measured() const { return static_cast<int>(asides_.size()); }
  int wanted() const;
  /// The disc reached the side of the screen without having vanished.
  bool ranOut(double seconds) const;

  const ScreenCalibration& result() const { return result_; }

 private:
  void goOn();
  void pressCard(Key key);
  void pressTape(Key key);
  void pressBlindSpot(Key key, double seconds);
  double pixelsPerMillimeter() const;

  CalibrationWishes wishes_;
  CalibratedScreen screen_;
  Step step_ = Step::kCard;
  double cardWidth_;  ///< pixels
  std::string typed_{};
  std::optional<double> discBegan_{};
  std::vector<double> asides_{};  ///< millimetres
  ScreenCalibration result_{};
};

}  // namespace ocelli
