// A device that passes everything on to another one and writes it down (docs/device_log.md).
//
// Nobody waits for the disk: of frames that come faster than they can be written some are left out of the log,
// which is told. A disk that is full ends the recording, not the device: close() throws then.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "display_driver/device/device.h"

namespace ocelli {

/// `tell` hears, for people, when the recording breaks and in the end of what is missing in it: once each, within
/// telemetry() or close(). Throws WorkError where the file cannot be made.
std::unique_ptr<Device> recordDeviceLog(std::unique_ptr<Device> device, const std::filesystem::path& path,
                                        std::function<void(const std::string&)> tell = {});

}  // namespace ocelli
