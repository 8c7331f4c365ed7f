// Answers control transfers to an emulated display: strings by itself, the requests of the wire protocol through the
// device.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display_driver/firmware/emulated_device.h"

namespace ocelli {

struct ControlAnswer {
  bool stalled = false;
  std::vector<uint8_t> bytes;  ///< of transfers to the host
  size_t taken = 0;            ///< of transfers to the device
};

inline constexpr size_t kSetupBytes = 8;

/// `transfer`: the setup packet, and for transfers to the device the bytes that follow it.
ControlAnswer answerControl(EmulatedDevice& device, std::span<const uint8_t> transfer, DeviceMicroseconds now);

}  // namespace ocelli
