#include "display_driver/emulator/usb_device_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "display_driver/wire/wire_format.h"
#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

// Of the test range of pid.codes: for devices that never leave the laboratory. Displays are not found by them.
constexpr uint16_t kVendor = 0x1209;
constexpr uint16_t kProduct = 0x0001;

constexpr uint8_t kDeviceType = 1;
constexpr uint8_t kConfigurationType = 2;
constexpr uint8_t kStringType = 3;
constexpr uint8_t kInterfaceType = 4;
constexpr uint8_t kEndpointType = 5;
constexpr uint8_t kCompanionType = 0x30;
constexpr uint8_t kBulk = 2;

/// Of a string descriptor, whose length is a byte: two for the head, two for each letter.
constexpr size_t kMaxStringLetters = 126;

uint8_t low(size_t number) {
  return static_cast<uint8_t>(number & 0xff);
}
uint8_t high(size_t number) {
  return static_cast<uint8_t>(number >> 8 & 0xff);
}

void append(std::vector<uint8_t>& bytes, const std::vector<uint8_t>& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

std::vector<uint8_t> endpoint(uint8_t address, EmulatedSpeed speed) {
  const bool fast = speed == EmulatedSpeed::kUsb3;
  const size_t packet = bulkPacketBytes(speed);
  std::vector<uint8_t> bytes = {7, kEndpointType, address, kBulk, low(packet), high(packet), 0};
  if (fast) {
    append(bytes, {6, kCompanionType, 15, 0, 0, 0});  // bursts of 16 packets
  }
  return bytes;
}

std::string hexOf(const std::vector<uint8_t>& bytes) {
  std::string text;
  for (const uint8_t byte : bytes) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

std::string record(const std::string& path, int number, const char* speed, const std::vector<uint8_t>& descriptors,
                   const std::string& more) {
  return fmt::format(
      "P: {0}\nN: {1}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DRIVER=usb\nE: BUSNUM=001\nE: DEVNUM={2:03}\n"
      "E: DEVNAME={3}\nA: busnum=1\\n\nA: devnum={2}\\n\nA: bConfigurationValue=1\\n\nA: speed={4}\\n\n{5}"
      "H: descriptors={6}\n",
      path, deviceFile(number).substr(5), number, deviceFile(number), speed, more, hexOf(descriptors));
}

}  // namespace

size_t bulkPacketBytes(EmulatedSpeed speed) {
  return speed == EmulatedSpeed::kUsb3 ? 1024 : 512;
}

std::vector<uint8_t> descriptorBytes(EmulatedSpeed speed) {
  const bool fast = speed == EmulatedSpeed::kUsb3;
  std::vector<uint8_t> bytes = {18,
                                kDeviceType,
                                0,
                                static_cast<uint8_t>(fast ? 3 : 2),
                                0,
                                0,
                                0,
                                static_cast<uint8_t>(fast ? 9 : 64),
                                low(kVendor),
                                high(kVendor),
                                low(kProduct),
                                high(kProduct),
                                0,
                                1,
                                kManufacturerString,
                                kProductString,
                                kSerialString,
                                1};
  std::vector<uint8_t> rest = {
      9, kInterfaceType, 0, 0, 2, wire::kInterfaceClass, wire::kInterfaceSubclass, wire::kInterfaceProtocol, 0};
  append(rest, endpoint(kEmulatedOutEndpoint, speed));
  append(rest, endpoint(kEmulatedInEndpoint, speed));
  const size_t total = 9 + rest.size();
  append(bytes, {9, kConfigurationType, low(total), high(total), 1, 1, 0, 0xc0, 0});  // with power of its own
  append(bytes, rest);
  return bytes;
}

void requireSerial(const std::string& serial) {
  const bool printable = std::ranges::all_of(serial, [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable || serial.size() > kMaxStringLetters) {
    throw InputError(
        "a serial number on USB has at most " + std::to_string(kMaxStringLetters) + " printable characters of ASCII",
        "serial number \"" + printableText(serial) + "\"", "letters and digits, such as EMULATED-2");
  }
}

std::vector<uint8_t> stringDescriptor(const std::string& text) {
  const std::string_view part = std::string_view(text).substr(0, kMaxStringLetters);
  std::vector<uint8_t> bytes = {static_cast<uint8_t>(2 + 2 * part.size()), kStringType};
  for (const char letter : part) {
    append(bytes, {static_cast<uint8_t>(letter), 0});
  }
  return bytes;
}

std::vector<uint8_t> languageDescriptor() {
  return {4, kStringType, 0x09, 0x04};
}

std::string deviceFile(int number) {
  return fmt::format("/dev/bus/usb/001/{:03}", number);
}

std::string devicePath(int port) {
  return fmt::format("/devices/usb1/1-{}", port);
}

std::string rootHubRecord() {
  const std::vector<uint8_t> hub = {18,
                                    kDeviceType,
                                    0,
                                    2,
                                    9,
                                    0,
                                    1,
                                    64,
                                    0x6b,
                                    0x1d,
                                    2,
                                    0,
                                    0,
                                    1,
                                    0,
                                    0,
                                    0,
                                    1,
                                    9,
                                    kConfigurationType,
                                    25,
                                    0,
                                    1,
                                    1,
                                    0,
                                    0xe0,
                                    0,
                                    9,
                                    kInterfaceType,
                                    0,
                                    0,
                                    1,
                                    9,
                                    0,
                                    0,
                                    0,
                                    7,
                                    kEndpointType,
                                    0x81,
                                    3,
                                    4,
                                    0,
                                    12};
  return record("/devices/usb1", 1, "480", hub, "");
}

std::string recordOf(const UsbDeviceRecord& device) {
  const std::string more =
      fmt::format("A: product={}\\n\nA: serial={}\\n\nA: devpath={}\\n\nE: ID_USB_INTERFACES=:ff4f01:\n",
                  device.product, device.serial, device.port);
  return record(devicePath(device.port), device.number, device.speed == EmulatedSpeed::kUsb3 ? "5000" : "480",
                descriptorBytes(device.speed), more);
}

}  // namespace ocelli
