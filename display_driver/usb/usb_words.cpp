#include "display_driver/usb/usb_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "display_driver/wire/bandwidth_plan.h"

namespace ocelli {

std::string describe(const UsbPlace& place) {
  const char* speed = "USB, unknown speed";
  switch (place.speed) {
    case UsbSpeed::kUnknown:
      break;
    case UsbSpeed::kLow:
      speed = "USB 1, 1.5 Mbit/s";
      break;
    case UsbSpeed::kFull:
      speed = "USB 1, 12 Mbit/s";
      break;
    case UsbSpeed::kHigh:
      speed = "USB 2, 480 Mbit/s";
      break;
    case UsbSpeed::kSuper:
      speed = "USB 3, 5 Gbit/s";
      break;
    case UsbSpeed::kSuperPlus:
      speed = "USB 3, 10 Gbit/s";
      break;
  }
  const std::string ports = place.ports.empty() ? "" : fmt::format(" port {}", fmt::join(place.ports, "."));
  return fmt::format("{}, bus {}{}", speed, place.bus, ports);
}

double practicalBytesPerSecond(UsbSpeed speed) {
  switch (speed) {
    case UsbSpeed::kUnknown:
      return 0;
    case UsbSpeed::kLow:
      return 0;  // has no bulk transfers
    case UsbSpeed::kFull:
      return 1.0e6;
    case UsbSpeed::kHigh:
      return wire::kUsb2BytesPerSecond;
    case UsbSpeed::kSuper:
      return wire::kUsb3BytesPerSecond;
    case UsbSpeed::kSuperPlus:
      return 900e6;
  }
  return 0;
}

std::string noRightsMessage(const std::string& place) {
  return fmt::format(
      "no right to use the display at {}: 70-ocelli.rules, copied to /etc/udev/rules.d, gives it (docs/install.md)",
      place);
}

std::string inUseMessage(const std::string& place) {
  return fmt::format("another program uses the display at {}", place);
}

}  // namespace ocelli
