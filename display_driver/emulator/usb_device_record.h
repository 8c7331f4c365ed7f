// An emulated display as the system describes it: its descriptors, and its entry in the tree of devices.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ocelli {

enum class EmulatedSpeed { kUsb2, kUsb3 };

inline constexpr uint8_t kEmulatedOutEndpoint = 0x01;
inline constexpr uint8_t kEmulatedInEndpoint = 0x81;

/// String descriptors of the device, by index.
inline constexpr uint8_t kManufacturerString = 1;
inline constexpr uint8_t kProductString = 2;
inline constexpr uint8_t kSerialString = 3;

size_t bulkPacketBytes(EmulatedSpeed speed);
/// The device descriptor and that of its only configuration, one after the other, as sysfs has them.
std::vector<uint8_t> descriptorBytes(EmulatedSpeed speed);
/// A string descriptor of ASCII text.
std::vector<uint8_t> stringDescriptor(const std::string& text);
/// Throws InputError where a string descriptor or umockdev cannot hold a serial number: it is up to 126 printable
/// characters of ASCII.
void requireSerial(const std::string& serial);
/// String descriptor 0: that strings are in English.
std::vector<uint8_t> languageDescriptor();

struct UsbDeviceRecord {
  int port = 1;    ///< of the root hub
  int number = 2;  ///< of the device on its bus: another one each time it is plugged in
  EmulatedSpeed speed = EmulatedSpeed::kUsb2;
  std::string product;
  std::string serial;
};

/// "/dev/bus/usb/001/002"
std::string deviceFile(int number);
/// "/devices/usb1/1-1"
std::string devicePath(int port);
/// In the format that umockdev reads.
std::string rootHubRecord();
std::string recordOf(const UsbDeviceRecord& device);

}  // namespace ocelli
