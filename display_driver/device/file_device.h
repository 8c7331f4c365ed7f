// The device `file`: a recording of what is shown, and when, as a `.svol` file that grows
// (display_sim/frames/svol_writer.h). Times count from the first frame. The file is made when that
// is shown; where none is, what stood under the name stays.
#pragma once

#include <filesystem>
#include <memory>

#include "display_driver/device/device.h"

namespace ocelli {

/// Throws InputError where the file's name does not end in .svol, WorkError where it could not be made. close() throws
/// WorkError where a part could not be written; what was written before is readable.
std::unique_ptr<Device> openFileDevice(const std::filesystem::path& path, const DisplayProfile& profile);

}  // namespace ocelli
