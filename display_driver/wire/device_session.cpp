#include "display_driver/wire/device_session.h"

#include <fmt/format.h>

#include <random>
#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {

DisplayIdentity identify(wire::Link& link) {
  const auto request = [](wire::Request r) { return static_cast<uint8_t>(r); };
  const std::string where = link.description().text;
  const auto identity = wire::identityFrom(link.controlIn(request(wire::Request::kIdentify), 0, wire::kIdentityBytes));
  if (!identity) {
    throw WorkError("the device does not identify itself as a display of the Ocelli protocol", where,
                    "compare its IDENTIFY request with docs/wire_protocol.md");
  }
  if (identity->majorVersion != wire::kMajorVersion) {
    throw WorkError(
        fmt::format("the display speaks version {}.{} of the protocol, and this program {}.{}", identity->majorVersion,
                    identity->minorVersion, wire::kMajorVersion, wire::kMinorVersion),
        where, "bring the older of both up to date");
  }
  const std::vector<uint8_t> profile = link.controlIn(request(wire::Request::kProfile), 0, wire::kMaxProfileBytes);
  if (profile.size() != identity->profileBytes || wire::crc32c(profile) != identity->profileChecksum) {
    throw WorkError("the profile of the display is not the one that its identity speaks of", where,
                    "compare its PROFILE request with docs/wire_protocol.md");
  }
  try {
    return {*identity, profileFromJsonText({profile.begin(), profile.end()}, "the profile of the display")};
  } catch (const InputError& error) {
    // What the device says is no input of the user's.
    throw WorkError("the profile that the display sent is wrong:", where, "mend the display's PROFILE answer",
                    error.what());
  }
}

void arm(wire::Link& link, uint32_t session) {
  link.controlOut(static_cast<uint8_t>(wire::Request::kArm), 1, toBytes(wire::Arm{.session = session}));
}

uint32_t newSession() {
  std::random_device random;
  uint32_t session = 0;
  while (session == 0) {
    session = random();
  }
  return session;
}

TelemetryAnswer askTelemetry(wire::Link& link) {
  try {
    const std::vector<uint8_t> bytes =
        link.controlIn(static_cast<uint8_t>(wire::Request::kTelemetry), 0, wire::kTelemetryBytes);
    const auto telemetry = wire::telemetryFrom(bytes);
    return {telemetry, telemetry ? "" : "the display's telemetry is damaged", false};
  } catch (const wire::LinkError& error) {
    return {std::nullopt, error.what(), error.status() == wire::LinkStatus::kGone};
  }
}

}  // namespace ocelli
