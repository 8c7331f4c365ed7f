// The simulated display: the firmware at the other end of a link in memory, fed with the exact bytes that hardware
// would get. Its screen turns in real time, with jitter where that is asked for.
#pragma once

#include <memory>

#include "display_driver/device/device.h"
#include "display_driver/firmware/emulated_device.h"

namespace ocelli {

struct SimOptions {
  EmulatedDeviceOptions display;
  /// Hears of every refresh, on the display's thread; lives as long as the device. nullptr: nobody does.
  RefreshSink* sink = nullptr;
};

/// Throws WorkError where the display is unplugged from the start.
std::unique_ptr<Device> openSimDevice(const SimOptions& options);

}  // namespace ocelli
