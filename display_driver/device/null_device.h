// The device `null`: takes everything and shows it nowhere, at the rate of its display. For trying pacing without any.
#pragma once

#include <memory>

#include "display_driver/device/device.h"

namespace ocelli {

std::unique_ptr<Device> openNullDevice(const DisplayProfile& profile);

}  // namespace ocelli
