#include "display_driver/firmware/memory_bus.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using wire::LinkError;
using wire::LinkStatus;

/// A device may need longer than this before it has something new to say, but not for bytes that wait.
constexpr std::chrono::microseconds kLongestSleep(1000);
/// Events in one piece.
constexpr size_t kMaxEventBytes = 64 * wire::kEventBytes;

struct Transfer {
  size_t tag = 0;
  std::span<const uint8_t> bytes;
  size_t taken = 0;
};

}  // namespace

struct MemoryBus::State {
  explicit State(EmulatedDeviceOptions options) : device(std::move(options)) {}

  DeviceMicroseconds now() const {
    const auto since = std::chrono::steady_clock::now() - start;
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
  }

  void run();
  void serve(std::unique_lock<std::mutex>& lock);
  void finish(std::unique_lock<std::mutex>& lock, LinkStatus status);
  void finishAll(std::unique_lock<std::mutex>& lock, LinkStatus status);

  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  std::mutex mutex;
  std::condition_variable changed;  ///< for the thread
  std::condition_variable idle;     ///< a call of the listener has returned, or transfers have ended
  std::condition_variable arrived;  ///< for ports
  EmulatedDevice device;
  bool ending = false;
  uint64_t arrivals = 0;  ///< how often the device was plugged in again
  bool open = false;
  bool woken = false;
  bool calling = false;  ///< the listener is being called
  bool broken = false;   ///< the link: the device has been unplugged since it was opened
  bool cancelling = false;
  bool stalled = false;
  wire::LinkListener listener;
  std::deque<Transfer> transfers;
  std::thread thread;
};

/// The oldest transfer has ended. The listener is called without the lock.
void MemoryBus::State::finish(std::unique_lock<std::mutex>& lock, LinkStatus status) {
  const Transfer transfer = transfers.front();
  transfers.pop_front();
  const auto sent = listener.sent;
  calling = true;
  lock.unlock();
  sent(transfer.tag, status, transfer.taken);
  lock.lock();
  calling = false;
  idle.notify_all();
}

void MemoryBus::State::finishAll(std::unique_lock<std::mutex>& lock, LinkStatus status) {
  while (!transfers.empty()) {
    finish(lock, status);
  }
}

void MemoryBus::State::serve(std::unique_lock<std::mutex>& lock) {
  if (cancelling) {
    finishAll(lock, LinkStatus::kCancelled);
    cancelling = false;
    idle.notify_all();
  }
  if (!open || broken || !listener.sent) {
    return;
  }
  if (!device.pluggedIn()) {
    broken = true;
    finishAll(lock, LinkStatus::kGone);
    const auto lost = listener.lost;
    if (open && lost) {
      calling = true;
      lock.unlock();
      lost(LinkStatus::kGone);
      lock.lock();
      calling = false;
      idle.notify_all();
    }
    return;
  }
  while (!transfers.empty() && !stalled && !cancelling && device.pluggedIn()) {
    Transfer& transfer = transfers.front();
    const EmulatedDevice::Taken taken = device.takeBulk(transfer.bytes.subspan(transfer.taken), now());
    transfer.taken += taken.bytes;
    if (taken.outcome == EmulatedDevice::Outcome::kStall) {
      stalled = true;
      // Not those that are sent meanwhile: the stall may have been cleared before.
      for (size_t left = transfers.size(); left > 0 && !transfers.empty(); --left) {
        finish(lock, LinkStatus::kStalled);
      }
    } else if (taken.outcome == EmulatedDevice::Outcome::kShort) {
      finish(lock, LinkStatus::kShort);
    } else if (transfer.taken == transfer.bytes.size()) {
      finish(lock, LinkStatus::kDone);
    } else {
      break;
    }
  }
  const std::vector<uint8_t> events = device.takeEvents(kMaxEventBytes, now());
  const auto received = listener.received;
  if (!events.empty() && open && received) {
    calling = true;
    lock.unlock();
    received(events);
    lock.lock();
    calling = false;
    idle.notify_all();
  }
}

void MemoryBus::State::run() {
  std::unique_lock lock(mutex);
  bool plugged = device.pluggedIn();
  while (!ending) {
    device.advance(now());
    serve(lock);
    if (device.pluggedIn() != plugged) {
      plugged = device.pluggedIn();
      arrivals += plugged ? 1 : 0;
      arrived.notify_all();
    }
    const DeviceMicroseconds time = now();
    const std::chrono::microseconds sleep(device.nextChange(time) - time);
    if (!woken) {
      changed.wait_for(lock, std::clamp(sleep, std::chrono::microseconds(50), kLongestSleep));
    }
    woken = false;
  }
}

namespace {

class MemoryLink : public wire::Link {
 public:
  explicit MemoryLink(std::shared_ptr<MemoryBus::State> state) : state_(std::move(state)) {
    const std::lock_guard lock(state_->mutex);
    description_ = {state_->device.firmware().options().serial, "memory", 0};
  }
  ~MemoryLink() override { MemoryLink::close(); }

  const wire::LinkDescription& description() const override { return description_; }

  std::vector<uint8_t> controlIn(uint8_t request, uint16_t value, size_t maxBytes) override {
    const std::lock_guard lock(state_->mutex);
    requirePlugged();
    auto answer = state_->device.controlIn(request, value, maxBytes, state_->now());
    if (!answer) {
      throw LinkError(LinkStatus::kStalled, "the device refused a request");
    }
    return *std::move(answer);
  }

  void controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) override {
    const std::lock_guard lock(state_->mutex);
    requirePlugged();
    if (!state_->device.controlOut(request, value, bytes, state_->now())) {
      throw LinkError(LinkStatus::kStalled, "the device refused a request");
    }
  }

  void start(wire::LinkListener listener) override {
    const std::lock_guard lock(state_->mutex);
    state_->listener = std::move(listener);
    wakeThread();
  }

  bool send(size_t tag, std::span<const uint8_t> bytes) override {
    const std::lock_guard lock(state_->mutex);
    if (closed_ || state_->broken || state_->stalled) {
      return false;
    }
    state_->transfers.push_back({tag, bytes, 0});
    wakeThread();
    return true;
  }

  void cancelAll() override {
    std::unique_lock lock(state_->mutex);
    cancel(lock);
  }

  void clearStall() override {
    const std::lock_guard lock(state_->mutex);
    requirePlugged();
    state_->device.clearHalt();
    state_->stalled = false;
  }

  void resetDevice() override {
    const std::lock_guard lock(state_->mutex);
    state_->device.firmware().restart(state_->now());
    state_->broken = true;
  }

  void close() override {
    std::unique_lock lock(state_->mutex);
    if (closed_) {
      return;
    }
    cancel(lock);
    state_->open = false;
    state_->idle.wait(lock, [&] { return !state_->calling; });
    state_->listener = {};
    closed_ = true;
  }

 private:
  void requirePlugged() const {
    if (!state_->device.pluggedIn() || state_->broken) {
      throw LinkError(LinkStatus::kGone, "the device is gone");
    }
  }

  void wakeThread() {
    state_->woken = true;
    state_->changed.notify_one();
  }

  void cancel(std::unique_lock<std::mutex>& lock) {
    state_->cancelling = true;
    wakeThread();
    state_->idle.wait(lock, [&] { return !state_->cancelling && state_->transfers.empty() && !state_->calling; });
  }

  std::shared_ptr<MemoryBus::State> state_;
  wire::LinkDescription description_;
  bool closed_ = false;
};

class MemoryPort : public wire::LinkPort {
 public:
  explicit MemoryPort(std::shared_ptr<MemoryBus::State> state) : state_(std::move(state)) {}

  std::string description() const override { return "the simulated display"; }

  std::unique_ptr<wire::Link> open() override {
    {
      const std::lock_guard lock(state_->mutex);
      arrivals_ = state_->arrivals;
      if (!state_->device.pluggedIn()) {
        throw LinkError(LinkStatus::kGone, "the device is not there");
      }
      if (state_->open) {
        throw LinkError(LinkStatus::kFailed, "the device is in use");
      }
      state_->open = true;
      state_->broken = false;
      state_->stalled = state_->device.halted();
    }
    return std::make_unique<MemoryLink>(state_);
  }

  void waitForArrival(std::chrono::milliseconds timeout) override {
    std::unique_lock lock(state_->mutex);
    state_->arrived.wait_for(lock, timeout, [&] { return state_->arrivals != arrivals_ || wake_; });
    wake_ = false;
  }

  void wake() override {
    const std::lock_guard lock(state_->mutex);
    wake_ = true;
    state_->arrived.notify_all();
  }

 private:
  std::shared_ptr<MemoryBus::State> state_;
  uint64_t arrivals_ = 0;  ///< when it was tried last
  bool wake_ = false;
};

}  // namespace

MemoryBus::MemoryBus(EmulatedDeviceOptions options) : state_(std::make_shared<State>(std::move(options))) {
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

MemoryBus::~MemoryBus() {
  {
    const std::lock_guard lock(state_->mutex);
    OC_CHECK(!state_->open, "a link outlives its bus");
    state_->ending = true;
    state_->changed.notify_one();
  }
  state_->thread.join();
}

std::unique_ptr<wire::LinkPort> MemoryBus::port() {
  return std::make_unique<MemoryPort>(state_);
}

void MemoryBus::withDevice(const std::function<void(EmulatedDevice&, DeviceMicroseconds)>& use) {
  const std::lock_guard lock(state_->mutex);
  use(state_->device, state_->now());
}

}  // namespace ocelli
