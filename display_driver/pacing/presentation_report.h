// What `ocelli present` tells: of each miss, and of all in the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"
#include "display_driver/pacing/device_log_player.h"
#include "display_driver/pacing/eyes_source.h"
#include "display_driver/pacing/time_line.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct PresentationReport {
  DeviceInfo device;
  std::string profile;
  TimeLineSummary summary;
  Telemetry telemetry;
  std::vector<EyesSource::Stage> stages;  ///< of the making; may be empty
  uint64_t eyesLeftOut = 0;
  uint64_t malformedEyes = 0;
  std::string firstMalformedEye{};        ///< with what is wrong with it
  PredictionErrors prediction;            ///< of live eyes
  std::optional<StartedImages> starts{};  ///< of a camera whose images begin from what the last one knew
  bool absent = false;                    ///< the display never was there
  bool interrupted = false;
};

/// Throws WorkError, naming `device`, where the display showed no frame.
void requireFrames(const PresentationReport& report, const std::string& device);

/// Lines for people, each with its end.
std::string reportText(const PresentationReport& report);
std::string reportJson(const PresentationReport& report);
/// The same of a device log.
std::string reportText(const DeviceLogPlayed& played);
std::string reportJson(const DeviceLogPlayed& played);

/// One line without its end: "refresh 1203 at 12.345 s: source late".
std::string missText(const RefreshRecord& record, HostTime start);
/// "240 refreshes, 2 missed"
std::string statusText(uint64_t refreshes, uint64_t misses);

}  // namespace ocelli
