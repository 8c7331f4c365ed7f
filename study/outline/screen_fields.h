// What a study wants of its screen and of the timing of frames: the fields "screen" and "timing" of a protocol.
#pragma once

#include <array>
#include <optional>

#include "study/outline/protocol_reading.h"

namespace ocelli {

class JsonFields;

/// How the distance from the eye to the screen is known: as the protocol states it, by a tape, or by the blind spot.
enum class DistanceMeasure { kStated, kTape, kBlindSpot };
inline constexpr std::array kDistanceMeasures{DistanceMeasure::kStated, DistanceMeasure::kTape,
                                              DistanceMeasure::kBlindSpot};
/// "stated", "tape", "blind_spot".
const char* nameOf(DistanceMeasure measure);

/// What a session measures of its screen before it begins (study/screen/calibration.h).
struct CalibrationWishes {
  bool card = true;  ///< the size, with a card
  DistanceMeasure distance = DistanceMeasure::kStated;
  double tolerance = 0.05;  ///< by what share the screen may be off from what the protocol states
};

/// What is not said is empty.
struct StatedScreen {
  std::optional<double> widthMillimeters{};  ///< of what is lit
  std::optional<double> heightMillimeters{};
  std::optional<double> distanceMillimeters{};  ///< from the eye
  std::optional<double> refreshHertz{};         ///< that the monitor must have
  // Not read by analyses.
  std::optional<int> minWidth{};  ///< pixels
  std::optional<int> minHeight{};
  std::optional<double> gamma{};  ///< exponent from pixel values to light, as the monitor is set; stated, not measured
  std::optional<CalibrationWishes> calibration{};
  bool photodiodePatch = false;  ///< a square in the lower left corner, white in every other frame of a trial
};

struct TimingLimits {
  double lateFactor = 1.2;  ///< a frame of more intervals than that is a dropped one
  // Not read by analyses.
  double maxDroppedShare = 0.01;   ///< of a trial's frames; with more the trial is marked
  double maxJitterShare = 0.1;     ///< of the interval, standard deviation in the start-up check
  double refreshTolerance = 0.02;  ///< of the measured rate, relative to what the monitor says
};

/// Both throw InputError naming the field.
StatedScreen readStatedScreen(JsonFields& protocol, ProtocolReading reading);
TimingLimits readTimingLimits(JsonFields& protocol, ProtocolReading reading);

}  // namespace ocelli
