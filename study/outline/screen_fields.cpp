#include "study/outline/screen_fields.h"

#include "oc_core/base/json_fields.h"

namespace ocelli {

const char* nameOf(DistanceMeasure measure) {
  switch (measure) {
    case DistanceMeasure::kStated:
      return "stated";
    case DistanceMeasure::kTape:
      return "tape";
    case DistanceMeasure::kBlindSpot:
      return "blind_spot";
  }
  return "";
}

StatedScreen readStatedScreen(JsonFields& protocol, ProtocolReading reading) {
  StatedScreen screen;
  if (!protocol.has("screen")) {
    return screen;
  }
  const bool byStudy = reading == ProtocolReading::kByStudy;
  JsonFields fields = protocol.inner("screen");
  const auto number = [&](const char* name, double least, double most) {
    return fields.has(name) ? std::optional(byStudy ? fields.number(name, least, most) : fields.number(name, 0, 1e6))
                            : std::nullopt;
  };
  screen.widthMillimeters = number("width_millimeters", 50, 10000);
  screen.heightMillimeters = number("height_millimeters", 50, 10000);
  screen.distanceMillimeters = number("distance_millimeters", 50, 20000);
  screen.refreshHertz = number("refresh_hertz", 10, 1000);
  if (byStudy) {
    const auto pixels = [&](const char* name, int least) {
      return fields.has(name) ? std::optional(fields.integer(name, least, 16384)) : std::nullopt;
    };
    screen.minWidth = pixels("least_width", 640);
    screen.minHeight = pixels("least_height", 480);
    screen.gamma = number("gamma", 0.5, 4);
    if (fields.has("calibration")) {
      JsonFields calibration = fields.inner("calibration");
      CalibrationWishes wishes;
      wishes.card = calibration.boolean("card", wishes.card);
      wishes.distance = calibration.choiceOf("distance", kDistanceMeasures, wishes.distance);
      wishes.tolerance = calibration.number("tolerance", 0.005, 0.5, wishes.tolerance);
      if (!wishes.card && wishes.distance == DistanceMeasure::kStated) {
        calibration.fail("card", "is false and no \"distance\" is measured: leave the calibration out");
      }
      calibration.rejectUnknown();
      screen.calibration = wishes;
    }
    screen.photodiodePatch = fields.boolean("photodiode_patch", screen.photodiodePatch);
    fields.rejectUnknown();
  }
  return screen;
}

TimingLimits readTimingLimits(JsonFields& protocol, ProtocolReading reading) {
  TimingLimits timing;
  if (!protocol.has("timing")) {
    return timing;
  }
  JsonFields fields = protocol.inner("timing");
  if (reading == ProtocolReading::kByAnalysis) {
    timing.lateFactor = fields.number("late_factor", 1, 1000, timing.lateFactor);
    return timing;
  }
  timing.lateFactor = fields.number("late_factor", 1.01, 10, timing.lateFactor);
  timing.maxDroppedShare = fields.number("most_dropped_share", 0, 1, timing.maxDroppedShare);
  timing.maxJitterShare = fields.number("most_jitter_share", 0.001, 10, timing.maxJitterShare);
  timing.refreshTolerance = fields.number("refresh_tolerance", 0.0001, 1, timing.refreshTolerance);
  fields.rejectUnknown();
  return timing;
}

}  // namespace ocelli
