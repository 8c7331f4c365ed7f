// Devices, handles and transfers of libusb, and which of the devices are displays.
#pragma once

#include <libusb.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "display_driver/usb/usb_words.h"
#include "display_driver/wire/link.h"

namespace ocelli::usb {

wire::LinkStatus statusOf(int error);
wire::LinkStatus statusOf(libusb_transfer_status status);
/// Throws LinkError with what libusb says of the error.
[[noreturn]] void fail(int error, const std::string& doing);

/// Transfers that have been made and not freed.
std::atomic<size_t>& transfersAlive();
struct FreeTransfer {
  void operator()(libusb_transfer* transfer) const;
};
using Transfer = std::unique_ptr<libusb_transfer, FreeTransfer>;
Transfer newTransfer();

struct CloseHandle {
  void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Handle = std::unique_ptr<libusb_device_handle, CloseHandle>;

struct DisplayInterface {
  int configuration = 0;
  bool active = false;  ///< the device is in that configuration already
  int number = 0;
  int alternate = 0;
  uint8_t out = 0;
  uint8_t in = 0;
  int inPacketBytes = 0;
};

/// Nothing for a device that is no display.
std::optional<DisplayInterface> displayOf(libusb_device* device);
UsbPlace placeOf(libusb_device* device);
/// Throws LinkError, which says what stands in the way.
Handle openHandle(libusb_device* device);
/// A string descriptor; empty where `index` is 0. Throws LinkError.
std::string stringOf(const Handle& handle, uint8_t index, const char* what);
/// Configures the display and takes its interface. Throws LinkError.
void claim(const Handle& handle, const DisplayInterface& display);

/// All devices of the moment, in the order of their places.
class DeviceList {
 public:
  /// Throws LinkError.
  explicit DeviceList(libusb_context* context);
  ~DeviceList() { libusb_free_device_list(devices_, 1); }
  DeviceList(const DeviceList&) = delete;
  DeviceList& operator=(const DeviceList&) = delete;

  libusb_device** begin() const { return devices_; }
  libusb_device** end() const { return devices_ + count_; }

 private:
  libusb_device** devices_ = nullptr;
  size_t count_ = 0;
};

}  // namespace ocelli::usb
