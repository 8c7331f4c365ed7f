#include "display_driver/usb/usb_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "display_driver/wire/wire_format.h"

namespace ocelli::usb {

using wire::LinkError;
using wire::LinkStatus;

namespace {

std::optional<DisplayInterface> interfaceOf(const libusb_interface_descriptor& descriptor) {
  if (descriptor.bInterfaceClass != wire::kInterfaceClass ||
      descriptor.bInterfaceSubClass != wire::kInterfaceSubclass ||
      descriptor.bInterfaceProtocol != wire::kInterfaceProtocol) {
    return std::nullopt;
  }
  DisplayInterface found{.number = descriptor.bInterfaceNumber, .alternate = descriptor.bAlternateSetting};
  for (int i = 0; i < descriptor.bNumEndpoints; ++i) {
    const libusb_endpoint_descriptor& endpoint = descriptor.endpoint[i];
    if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) != LIBUSB_TRANSFER_TYPE_BULK) {
      continue;
    }
    if ((endpoint.bEndpointAddress & LIBUSB_ENDPOINT_DIR_MASK) == LIBUSB_ENDPOINT_OUT) {
      found.out = found.out == 0 ? endpoint.bEndpointAddress : found.out;
    } else if (found.in == 0) {
      found.in = endpoint.bEndpointAddress;
      found.inPacketBytes = endpoint.wMaxPacketSize & 0x7ff;
    }
  }
  return found.inPacketBytes != 0 && found.out != 0 ? std::optional(found) : std::nullopt;
}

}  // namespace

LinkStatus statusOf(int error) {
  switch (error) {
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return LinkStatus::kGone;
    case LIBUSB_ERROR_TIMEOUT:
      return LinkStatus::kTimedOut;
    case LIBUSB_ERROR_PIPE:
      return LinkStatus::kStalled;
    default:
      return LinkStatus::kFailed;
  }
}

void fail(int error, const std::string& doing) {
  throw LinkError(statusOf(error), fmt::format("{}: {}", doing, libusb_strerror(error)));
}

LinkStatus statusOf(libusb_transfer_status status) {
  switch (status) {
    case LIBUSB_TRANSFER_COMPLETED:
      return LinkStatus::kDone;
    case LIBUSB_TRANSFER_TIMED_OUT:
      return LinkStatus::kTimedOut;
    case LIBUSB_TRANSFER_CANCELLED:
      return LinkStatus::kCancelled;
    case LIBUSB_TRANSFER_STALL:
      return LinkStatus::kStalled;
    case LIBUSB_TRANSFER_NO_DEVICE:
      return LinkStatus::kGone;
    case LIBUSB_TRANSFER_ERROR:
    case LIBUSB_TRANSFER_OVERFLOW:
      return LinkStatus::kFailed;
  }
  return LinkStatus::kFailed;
}

std::atomic<size_t>& transfersAlive() {
  static std::atomic<size_t> alive = 0;
  return alive;
}

void FreeTransfer::operator()(libusb_transfer* transfer) const {
  libusb_free_transfer(transfer);
  --transfersAlive();
}

Transfer newTransfer() {
  libusb_transfer* const transfer = libusb_alloc_transfer(0);
  if (transfer == nullptr) {
    throw std::bad_alloc();
  }
  ++transfersAlive();
  return Transfer(transfer);
}

std::optional<DisplayInterface> displayOf(libusb_device* device) {
  libusb_config_descriptor* descriptor = nullptr;
  const bool active = libusb_get_active_config_descriptor(device, &descriptor) == 0;
  if (!active && libusb_get_config_descriptor(device, 0, &descriptor) != 0) {
    return std::nullopt;
  }
  const std::unique_ptr<libusb_config_descriptor, decltype(&libusb_free_config_descriptor)> owner(
      descriptor, libusb_free_config_descriptor);
  for (int i = 0; i < descriptor->bNumInterfaces; ++i) {
    const libusb_interface& alternatives = descriptor->interface[i];
    for (int j = 0; j < alternatives.num_altsetting; ++j) {
      if (auto found = interfaceOf(alternatives.altsetting[j])) {
        found->configuration = descriptor->bConfigurationValue;
        found->active = active;
        return found;
      }
    }
  }
  return std::nullopt;
}

UsbPlace placeOf(libusb_device* device) {
  UsbPlace place;
  place.bus = libusb_get_bus_number(device);
  std::array<uint8_t, 7> ports{};  // as deep as USB goes
  const int depth = libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  place.ports.assign(ports.begin(), ports.begin() + std::max(depth, 0));
  switch (libusb_get_device_speed(device)) {
    case LIBUSB_SPEED_LOW:
      place.speed = UsbSpeed::kLow;
      break;
    case LIBUSB_SPEED_FULL:
      place.speed = UsbSpeed::kFull;
      break;
    case LIBUSB_SPEED_HIGH:
      place.speed = UsbSpeed::kHigh;
      break;
    case LIBUSB_SPEED_SUPER:
      place.speed = UsbSpeed::kSuper;
      break;
    case LIBUSB_SPEED_SUPER_PLUS:
      place.speed = UsbSpeed::kSuperPlus;
      break;
    default:
      break;
  }
  return place;
}

Handle openHandle(libusb_device* device) {
  libusb_device_handle* handle = nullptr;
  const int error = libusb_open(device, &handle);
  if (error == LIBUSB_ERROR_ACCESS) {
    throw LinkError(LinkStatus::kFailed, noRightsMessage(describe(placeOf(device))));
  }
  if (error != 0) {
    fail(error, fmt::format("cannot open the display at {}", describe(placeOf(device))));
  }
  return Handle(handle);
}

std::string stringOf(const Handle& handle, uint8_t index, const char* what) {
  if (index == 0) {
    return "";
  }
  std::array<unsigned char, 256> text{};
  const int length =
      libusb_get_string_descriptor_ascii(handle.get(), index, text.data(), static_cast<int>(text.size()));
  if (length < 0) {
    fail(length, fmt::format("the display does not tell its {}", what));
  }
  return std::string(text.begin(), text.begin() + length);
}

void claim(const Handle& handle, const DisplayInterface& display) {
  const std::string place = describe(placeOf(libusb_get_device(handle.get())));
  // A driver of the kernel that has taken the interface gives it back when it is released.
  libusb_set_auto_detach_kernel_driver(handle.get(), 1);
  if (!display.active) {
    if (const int error = libusb_set_configuration(handle.get(), display.configuration); error != 0) {
      fail(error, fmt::format("cannot configure the display at {}", place));
    }
  }
  const int error = libusb_claim_interface(handle.get(), display.number);
  if (error == LIBUSB_ERROR_BUSY) {
    throw LinkError(LinkStatus::kFailed, inUseMessage(place));
  }
  if (error != 0) {
    fail(error, fmt::format("cannot claim the display at {}", place));
  }
  if (display.alternate != 0) {
    if (const int setting = libusb_set_interface_alt_setting(handle.get(), display.number, display.alternate);
        setting != 0) {
      fail(setting, fmt::format("cannot switch the interface of the display at {}", place));
    }
  }
  // The program that had the display before may have left them halted. Not possible where a transfer is under way: the
  // host would count packets on, and the device from 0.
  libusb_clear_halt(handle.get(), display.out);
  libusb_clear_halt(handle.get(), display.in);
}

DeviceList::DeviceList(libusb_context* context) {
  const ssize_t count = libusb_get_device_list(context, &devices_);
  if (count < 0) {
    fail(static_cast<int>(count), "cannot list the devices on USB");
  }
  count_ = static_cast<size_t>(count);
  std::sort(begin(), end(), [](libusb_device* a, libusb_device* b) {
    const UsbPlace first = placeOf(a);
    const UsbPlace second = placeOf(b);
    return std::tie(first.bus, first.ports) < std::tie(second.bus, second.ports);
  });
}
}  // namespace ocelli::usb
