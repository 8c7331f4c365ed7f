// One connection to a display: what it says of itself, and a session in which frames are numbered and counted.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "display_driver/wire/frame_encoder.h"
#include "display_driver/wire/link.h"
#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/display_profile.h"

namespace ocelli {

/// What a display told about itself when it was asked.
struct DisplayIdentity {
  wire::Identity identity;
  DisplayProfile profile;
};

/// Asks. Throws LinkError where requests fail, and WorkError where the answers make no sense: another version of the
/// protocol, an invalid profile.
DisplayIdentity identify(wire::Link& link);

/// Arms the display for a new session. Throws LinkError.
void arm(wire::Link& link, uint32_t session);

/// A number that the display has most probably not seen yet; never 0.
uint32_t newSession();

/// What a request for telemetry gave.
struct TelemetryAnswer {
  std::optional<wire::DeviceTelemetry> telemetry;  ///< nullopt where it failed, or the answer is damaged
  std::string problem;                             ///< why; empty where it did not fail
  bool gone = false;                               ///< the display is
};

TelemetryAnswer askTelemetry(wire::Link& link);

}  // namespace ocelli
