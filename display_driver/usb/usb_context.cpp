#include "display_driver/usb/usb_context.h"

#include <algorithm>

#include "display_driver/usb/usb_handles.h"

namespace ocelli::usb {
namespace {

constexpr std::chrono::milliseconds kTick{100};     // of the event thread, to look for sends that do not move
constexpr std::chrono::milliseconds kPolling{250};  // where libusb does not tell of arrivals

}  // namespace

Context::Context() {
  if (const int error = libusb_init(&context_); error != 0) {
    fail(error, "USB cannot be used");
  }
  if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) != 0) {
    hearsOfArrivals_ =
        libusb_hotplug_register_callback(
            context_, LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
            LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, hotplug, this, nullptr) == 0;
  }
  thread_ = std::thread([this] { run(); });
}

Context::~Context() {
  stop_ = true;
  libusb_interrupt_event_handler(context_);
  thread_.join();
  libusb_exit(context_);
}

void Context::run() {
  while (!stop_) {
    timeval tick{.tv_sec = 0, .tv_usec = std::chrono::microseconds(kTick).count()};
    if (libusb_handle_events_timeout_completed(context_, &tick, nullptr) != 0 && !stop_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // a failure that lasts must not take a whole core
    }
    const std::scoped_lock lock(mutex_);
    for (EventTarget* target : targets_) {
      target->checkProgress(std::chrono::steady_clock::now());
    }
  }
}

int Context::hotplug(libusb_context*, libusb_device* device, libusb_hotplug_event event, void* self) {
  Context& context = *static_cast<Context*>(self);
  if (event == LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT) {
    context.left(device);
  } else {
    const std::scoped_lock lock(context.mutex_);
    ++context.arrivals_;
    context.arrived_.notify_all();
  }
  return 0;
}

void Context::left(libusb_device* device) {
  const std::scoped_lock lock(mutex_);
  for (EventTarget* target : targets_) {
    if (target->device() == device) {
      target->deviceLeft();
    }
  }
}

void Context::add(EventTarget* target) {
  const std::scoped_lock lock(mutex_);
  targets_.push_back(target);
}

void Context::remove(EventTarget* target) {
  const std::scoped_lock lock(mutex_);
  std::erase(targets_, target);
}

void Context::waitForArrival(size_t seen, std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  arrived_.wait_for(lock, hearsOfArrivals_ ? timeout : std::min(timeout, kPolling),
                    [&] { return woken_ || arrivals_ != seen; });
  woken_ = false;
}

void Context::wake() {
  const std::scoped_lock lock(mutex_);
  woken_ = true;
  arrived_.notify_all();
}

}  // namespace ocelli::usb
