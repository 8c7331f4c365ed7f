#include "display_driver/emulator/usb_function.h"

#include <algorithm>

#include "display_driver/emulator/usb_device_record.h"

namespace ocelli {
namespace {

constexpr uint8_t kToHost = 0x80;
constexpr uint8_t kStandardIn = 0x80;
constexpr uint8_t kVendorToInterface = 0x41;
constexpr uint8_t kGetDescriptor = 6;
constexpr uint8_t kStringDescriptor = 3;

struct Setup {
  uint8_t type;
  uint8_t request;
  uint16_t value;
  uint16_t length;
};

ControlAnswer answerWith(std::vector<uint8_t> bytes, size_t most) {
  bytes.resize(std::min(bytes.size(), most));
  return {.stalled = false, .bytes = std::move(bytes), .taken = 0};
}

ControlAnswer stalled() {
  return {.stalled = true, .bytes = {}, .taken = 0};
}

ControlAnswer answerString(const FirmwareOptions& device, uint8_t index, size_t most) {
  switch (index) {
    case 0:
      return answerWith(languageDescriptor(), most);
    case kManufacturerString:
      return answerWith(stringDescriptor("Ocelli"), most);
    case kProductString:
      return answerWith(stringDescriptor(device.name), most);
    case kSerialString:
      return answerWith(stringDescriptor(device.serial), most);
    default:
      return stalled();
  }
}

}  // namespace

ControlAnswer answerControl(EmulatedDevice& device, std::span<const uint8_t> transfer, DeviceMicroseconds now) {
  if (transfer.size() < kSetupBytes) {
    return stalled();
  }
  const Setup setup{.type = transfer[0],
                    .request = transfer[1],
                    .value = static_cast<uint16_t>(transfer[2] | transfer[3] << 8),
                    .length = static_cast<uint16_t>(transfer[6] | transfer[7] << 8)};
  if (setup.type == kStandardIn && setup.request == kGetDescriptor && setup.value >> 8 == kStringDescriptor) {
    return answerString(device.firmware().options(), static_cast<uint8_t>(setup.value & 0xff), setup.length);
  }
  if (setup.type == (kVendorToInterface | kToHost)) {
    auto bytes = device.controlIn(setup.request, setup.value, setup.length, now);
    return bytes ? answerWith(std::move(*bytes), setup.length) : stalled();
  }
  if (setup.type == kVendorToInterface) {
    const std::span<const uint8_t> bytes = transfer.subspan(kSetupBytes);
    return device.controlOut(setup.request, setup.value, bytes, now)
               ? ControlAnswer{.stalled = false, .bytes = {}, .taken = bytes.size()}
               : stalled();
  }
  return stalled();
}

}  // namespace ocelli
