// libusb itself, the thread that handles its events, and who wants to hear of what. On that thread come completions of
// transfers, arrivals and departures.
#pragma once

#include <libusb.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace ocelli::usb {

/// Who hears of what happens, on the event thread.
class EventTarget {
 public:
  virtual ~EventTarget() = default;
  virtual libusb_device* device() const = 0;
  virtual void deviceLeft() = 0;
  /// Now and then, to look for transfers that do not move.
  virtual void checkProgress(std::chrono::steady_clock::time_point now) = 0;
};

class Context {
 public:
  /// Throws LinkError where USB cannot be used.
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  libusb_context* get() const { return context_; }
  bool onEventThread() const { return std::this_thread::get_id() == thread_.get_id(); }
  bool hearsOfArrivals() const { return hearsOfArrivals_; }
  void add(EventTarget* target);
  void remove(EventTarget* target);

  /// Displays and other devices that have come since it was made.
  size_t arrivals() const { return arrivals_; }
  /// Until there are more arrivals, wake() or the end of the time.
  void waitForArrival(size_t seen, std::chrono::milliseconds timeout);
  void wake();

 private:
  static int hotplug(libusb_context*, libusb_device* device, libusb_hotplug_event event, void* self);
  void left(libusb_device* device);
  void run();

  libusb_context* context_ = nullptr;
  bool hearsOfArrivals_ = false;
  std::mutex mutex_;
  std::condition_variable arrived_;
  bool woken_ = false;
  std::vector<EventTarget*> targets_;
  std::atomic<size_t> arrivals_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace ocelli::usb
