// A device that passes everything on to another one and writes it down (docs/session_recording.md).
//
// A session leaves nothing out: where frames come faster than they can be written, submit() waits until there is room.
// A disk that is full ends the recording, not the device: close() throws then.
#pragma once

#include <filesystem>
#include <memory>

#include "display_driver/device/device.h"

namespace ocelli {

/// Throws WorkError where the file cannot be made.
std::unique_ptr<Device> recordSession(std::unique_ptr<Device> device, const std::filesystem::path& path);

}  // namespace ocelli
