#include "display_driver/usb/usb_port.h"

#include <fmt/format.h>

#include <atomic>
#include <optional>
#include <utility>

#include "display_driver/usb/usb_link.h"

namespace ocelli {

using wire::LinkError;
using wire::LinkStatus;

struct UsbPort::State {
  explicit State(UsbPortOptions given) : options(std::move(given)) {}

  const UsbPortOptions options;
  std::shared_ptr<usb::Context> context = std::make_shared<usb::Context>();
  std::atomic<size_t> arrivalsSeen = 0;
};

UsbPort::UsbPort(UsbPortOptions options) : state_(std::make_unique<State>(std::move(options))) {}

UsbPort::~UsbPort() = default;

std::string UsbPort::description() const {
  const std::string& serial = state_->options.serial;
  return serial.empty() ? "a display on USB" : fmt::format("the display on USB with the serial {}", serial);
}

std::unique_ptr<wire::Link> UsbPort::open() {
  state_->arrivalsSeen = state_->context->arrivals();
  std::optional<LinkError> problem;
  for (libusb_device* const device : usb::DeviceList(state_->context->get())) {
    const std::optional<usb::DisplayInterface> display = usb::displayOf(device);
    if (!display) {
      continue;
    }
    try {
      libusb_device_descriptor descriptor{};
      libusb_get_device_descriptor(device, &descriptor);
      usb::Handle handle = usb::openHandle(device);
      const UsbPlace place = usb::placeOf(device);
      wire::LinkDescription description{.serial = usb::stringOf(handle, descriptor.iSerialNumber, "serial"),
                                        .text = describe(place),
                                        .bytesPerSecond = practicalBytesPerSecond(place.speed)};
      if (!state_->options.serial.empty() && description.serial != state_->options.serial) {
        continue;
      }
      usb::claim(handle, *display);
      return std::make_unique<usb::UsbLink>(state_->context, std::move(handle), *display, std::move(description),
                                            state_->options);
    } catch (const LinkError& error) {
      // Another display may do. One that has just been unplugged is no problem worth telling.
      if (error.status() != LinkStatus::kGone) {
        problem = error;
      }
    }
  }
  if (problem) {
    throw *problem;
  }
  throw LinkError(LinkStatus::kGone, "not plugged in, or not switched on");
}

void UsbPort::waitForArrival(std::chrono::milliseconds timeout) {
  state_->context->waitForArrival(state_->arrivalsSeen, timeout);
  state_->arrivalsSeen = state_->context->arrivals();
}

void UsbPort::wake() {
  state_->context->wake();
}

std::vector<UsbDisplay> listUsbDisplays() {
  usb::Context context;
  std::vector<UsbDisplay> displays;
  for (libusb_device* const device : usb::DeviceList(context.get())) {
    if (!usb::displayOf(device)) {
      continue;
    }
    libusb_device_descriptor descriptor{};
    libusb_get_device_descriptor(device, &descriptor);
    UsbDisplay display;
    display.vendor = descriptor.idVendor;
    display.product = descriptor.idProduct;
    display.link = describe(usb::placeOf(device));
    try {
      const usb::Handle handle = usb::openHandle(device);
      display.serial = usb::stringOf(handle, descriptor.iSerialNumber, "serial");
      display.name = usb::stringOf(handle, descriptor.iProduct, "name");
    } catch (const LinkError& error) {
      display.problem = error.what();
    }
    displays.push_back(std::move(display));
  }
  return displays;
}

size_t usbTransfersAlive() {
  return usb::transfersAlive();
}

}  // namespace ocelli
