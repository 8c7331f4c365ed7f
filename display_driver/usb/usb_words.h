// What USB's figures and failures mean to people.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli {

enum class UsbSpeed { kUnknown, kLow, kFull, kHigh, kSuper, kSuperPlus };

struct UsbPlace {
  UsbSpeed speed = UsbSpeed::kUnknown;
  uint8_t bus = 0;
  std::vector<uint8_t> ports;  ///< from the root hub on
};

/// "USB 2, 480 Mbit/s, bus 1 port 2.3"
std::string describe(const UsbPlace& place);
/// That bulk transfers reach in practice; 0: not known.
double practicalBytesPerSecond(UsbSpeed speed);

/// Messages for what stands in the way of a display at a place, in a line.
std::string noRightsMessage(const std::string& place);
std::string inUseMessage(const std::string& place);

}  // namespace ocelli
