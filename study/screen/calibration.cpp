#include "study/screen/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr double kMinCardPixels = 60;
constexpr size_t kMaxDigits = 4;
constexpr int kBlindSpotTrials = 5;
/// The disc moves so far in a second: slowly enough for half a second of reaction to cost 5 %.
constexpr double kDiscMillimetersPerSecond = 15;
/// It begins so far from the cross: nearer than the blind spot of an eye at 25 cm.
constexpr double kDiscBeginsMillimeters = 40;
/// Where the cross stands, as shares of the screen: the disc has the room to its left.
constexpr glm::dvec2 kCrossPlace{0.88, 0.55};

}  // namespace

double distanceFromBlindSpot(double millimetersAside) {
  return millimetersAside / std::tan(radiansFromDegrees(kBlindSpotDegrees));
}

double degreesPerPixel(double pixelsPerMillimeter, double distanceMillimeters) {
  return 2 * degreesFromRadians(std::atan(0.5 / pixelsPerMillimeter / distanceMillimeters));
}

std::string ScreenCalibration::jsonText(const CalibrationWishes& wishes) const {
  const auto orNull = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  const nlohmann::ordered_json json{{"card", wishes.card},
                                    {"distance", nameOf(wishes.distance)},
                                    {"pixels_per_millimeter", orNull(pixelsPerMillimeter)},
                                    {"distance_millimeters", orNull(distanceMillimeters)},
                                    {"distance_spread", orNull(distanceSpread)}};
  return textOfJson(json);
}

std::vector<std::string> deviationsOf(const ScreenCalibration& measured, const CalibratedScreen& stated,
                                      double tolerance) {
  std::vector<std::string> found;
  const auto compare = [&](const char* what, double value, double wanted) {
    if (std::abs(value - wanted) > tolerance * wanted) {
      found.push_back(fmt::format("{} is {:.0f} mm, but the protocol states {:.0f} mm ({:+.1f} %)", what, value, wanted,
                                  100 * (value / wanted - 1)));
    }
  };
  if (measured.pixelsPerMillimeter) {
    compare("the screen's width", stated.width / *measured.pixelsPerMillimeter, stated.widthMillimeters);
  }
  if (measured.distanceMillimeters) {
    compare("the distance from the eye", *measured.distanceMillimeters, stated.distanceMillimeters);
  }
  return found;
}

std::string describe(const ScreenCalibration& measured, const CalibratedScreen& stated) {
  const double pixels = measured.pixelsPerMillimeter.value_or(stated.width / stated.widthMillimeters);
  const double distance = measured.distanceMillimeters.value_or(stated.distanceMillimeters);
  const auto how = [](bool wasMeasured) { return wasMeasured ? "measured" : "as stated"; };
  std::string text =
      fmt::format("{:.1f} pixels a centimetre ({}), {:.0f} mm from the eye ({}), {:.1f} pixels a degree in the middle",
                  10 * pixels, how(measured.pixelsPerMillimeter.has_value()), distance,
                  how(measured.distanceMillimeters.has_value()), 1 / degreesPerPixel(pixels, distance));
  if (measured.distanceSpread) {
    text += fmt::format("; single distances differ by {:.0f} %", 100 * *measured.distanceSpread);
  }
  return text;
}

CalibrationSteps::CalibrationSteps(const CalibrationWishes& wishes, const CalibratedScreen& screen)
    : wishes_(wishes),
      screen_(screen),
      // What the protocol states is where one begins, but not quite: who presses Enter at once is told that it is off.
      cardWidth_(std::round(0.8 * kCardWidthMillimeters * screen.width / screen.widthMillimeters)) {
  if (!wishes_.card) {
    goOn();
  }
}

void CalibrationSteps::goOn() {
  if (step_ == Step::kCard && wishes_.distance != DistanceMeasure::kStated) {
    step_ = wishes_.distance == DistanceMeasure::kTape ? Step::kTape : Step::kBlindSpot;
  } else {
    step_ = Step::kDone;
  }
}

double CalibrationSteps::pixelsPerMillimeter() const {
  return result_.pixelsPerMillimeter.value_or(screen_.width / screen_.widthMillimeters);
}

void CalibrationSteps::press(Key key, double seconds) {
  switch (step_) {
    case Step::kCard:
      pressCard(key);
      break;
    case Step::kTape:
      pressTape(key);
      break;
    case Step::kBlindSpot:
      pressBlindSpot(key, seconds);
      break;
    case Step::kDone:
      break;
  }
}

void CalibrationSteps::widenCard(double pixels) {
  const double most = std::min<double>(screen_.width, screen_.height * kCardWidthMillimeters / kCardHeightMillimeters);
  cardWidth_ = std::clamp(cardWidth_ + pixels, kMinCardPixels, most);
}

glm::dvec2 CalibrationSteps::cardPixels() const {
  return {cardWidth_, cardWidth_ * kCardHeightMillimeters / kCardWidthMillimeters};
}

void CalibrationSteps::pressCard(Key key) {
  constexpr double kManyPixels = 10;
  if (key == Key::kRight || key == Key::kLeft) {
    widenCard(key == Key::kRight ? 1 : -1);
  } else if (key == Key::kUp || key == Key::kDown) {
    widenCard(key == Key::kUp ? kManyPixels : -kManyPixels);
  } else if (key == Key::kEnter) {
    result_.pixelsPerMillimeter = cardWidth_ / kCardWidthMillimeters;
    goOn();
  }
}

bool CalibrationSteps::typedIsPossible() const {
  const int typed = typed_.empty() ? 0 : std::stoi(typed_);
  return typed >= kMinTapeMillimeters && typed <= kMaxTapeMillimeters;
}

void CalibrationSteps::pressTape(Key key) {
  if (key >= Key::k0 && key <= Key::k9 && typed_.size() < kMaxDigits) {
    typed_ += static_cast<char>('0' + (static_cast<int>(key) - static_cast<int>(Key::k0)));
  } else if (key == Key::kBackspace && !typed_.empty()) {
    typed_.pop_back();
  } else if (key == Key::kEnter && typedIsPossible()) {
    result_.distanceMillimeters = std::stoi(typed_);
    goOn();
  }
}

glm::dvec2 CalibrationSteps::cross() const {
  return {std::round(kCrossPlace.x * screen_.width), std::round(kCrossPlace.y * screen_.height)};
}

int CalibrationSteps::wanted() const {
  return kBlindSpotTrials;
}

std::optional<glm::dvec2> CalibrationSteps::disc(double seconds) const {
  if (!discBegan_) {
    return std::nullopt;
  }
  const double aside = kDiscBeginsMillimeters + kDiscMillimetersPerSecond * (seconds - *discBegan_);
  return glm::dvec2(std::max(0.0, cross().x - aside * pixelsPerMillimeter()), cross().y);
}

bool CalibrationSteps::ranOut(double seconds) const {
  const std::optional<glm::dvec2> at = disc(seconds);
  return at && at->x <= 0;
}

void CalibrationSteps::pressBlindSpot(Key key, double seconds) {
  if (key != Key::kSpace) {
    return;
  }
  if (!discBegan_ || ranOut(seconds)) {
    discBegan_ = seconds;
    return;
  }
  asides_.push_back((cross().x - disc(seconds)->x) / pixelsPerMillimeter());
  discBegan_.reset();
  if (measured() < wanted()) {
    return;
  }
  // The median: once one may have pressed too early.
  std::vector<double> sorted = asides_;
  std::sort(sorted.begin(), sorted.end());
  result_.distanceMillimeters = distanceFromBlindSpot(sorted[sorted.size() / 2]);
  double mean = 0;
  double squares = 0;
  for (const double aside : asides_) {
    mean += aside / measured();
  }
  for (const double aside : asides_) {
    squares += (aside - mean) * (aside - mean) / (measured() - 1);
  }
  result_.distanceSpread = std::sqrt(squares) / mean;
  goOn();
}

}  // namespace ocelli
