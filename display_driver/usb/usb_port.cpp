// The only file that includes libusb.
//
// Threads: each port has one that handles libusb's events. On it come completions of transfers, arrivals and
// departures, and from it the listeners of links are called, with no lock held. Everything else is called by users'
// threads. Locks, in the order in which they are taken: Context::mutex, UsbLink::order_, UsbLink::mutex_.
#include "display_driver/usb/usb_port.h"

#include <fmt/format.h>
#include <libusb.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <ranges>
#include <thread>
#include <tuple>
#include <utility>

#include "display_driver/usb/usb_words.h"
#include "display_driver/wire/wire_format.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using wire::LinkError;
using wire::LinkStatus;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kTick{100};     // of the event thread, to look for sends that do not move
constexpr std::chrono::milliseconds kPolling{250};  // where libusb does not tell of arrivals
constexpr size_t kEventTransfers = 8;               // waiting for events at the same time

std::atomic<size_t> transfersAlive = 0;

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

[[noreturn]] void fail(int error, const std::string& doing) {
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

struct FreeTransfer {
  void operator()(libusb_transfer* transfer) const {
    libusb_free_transfer(transfer);
    --transfersAlive;
  }
};
using Transfer = std::unique_ptr<libusb_transfer, FreeTransfer>;

Transfer newTransfer() {
  libusb_transfer* const transfer = libusb_alloc_transfer(0);
  if (transfer == nullptr) {
    throw std::bad_alloc();
  }
  ++transfersAlive;
  return Transfer(transfer);
}

struct CloseHandle {
  void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
};
using Handle = std::unique_ptr<libusb_device_handle, CloseHandle>;

// --- Displays among devices ---

struct DisplayInterface {
  int configuration = 0;
  bool active = false;  ///< the device is in that configuration already
  int number = 0;
  int alternate = 0;
  uint8_t out = 0;
  uint8_t in = 0;
  int inPacketBytes = 0;
};

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

/// Throws LinkError, which says what stands in the way.
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

/// Throws LinkError.
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
  // Whoever had the display before may have left them halted. Not possible where a transfer is under way: the host
  // would count packets on, and the device from 0.
  libusb_clear_halt(handle.get(), display.out);
  libusb_clear_halt(handle.get(), display.in);
}

// --- The context: libusb, its event thread, and who wants to hear of what ---

class UsbLink;

class Context {
 public:
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  libusb_context* get() const { return context_; }
  bool onEventThread() const { return std::this_thread::get_id() == thread_.get_id(); }
  bool hearsOfArrivals() const { return hearsOfArrivals_; }
  void add(UsbLink* link);
  void remove(UsbLink* link);

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
  std::vector<UsbLink*> links_;
  std::atomic<size_t> arrivals_ = 0;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

/// All devices of the moment, in the order of their places.
class DeviceList {
 public:
  explicit DeviceList(libusb_context* context) {
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
  ~DeviceList() { libusb_free_device_list(devices_, 1); }
  DeviceList(const DeviceList&) = delete;
  DeviceList& operator=(const DeviceList&) = delete;

  libusb_device** begin() const { return devices_; }
  libusb_device** end() const { return devices_ + count_; }

 private:
  libusb_device** devices_ = nullptr;
  size_t count_ = 0;
};

// --- A link ---

class UsbLink final : public wire::Link {
 public:
  UsbLink(std::shared_ptr<Context> context, Handle handle, const DisplayInterface& display,
          wire::LinkDescription description, const UsbPortOptions& options);
  ~UsbLink() override { shut(); }

  const wire::LinkDescription& description() const override { return description_; }
  std::vector<uint8_t> controlIn(uint8_t request, uint16_t value, size_t mostBytes) override;
  void controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) override;
  void start(wire::LinkListener listener) override;
  bool send(size_t tag, std::span<const uint8_t> bytes) override;
  void cancelAll() override;
  void clearStall() override;
  void resetDevice() override;
  void close() override { shut(); }

  // For the context, from the event thread.
  libusb_device* device() const { return libusb_get_device(handle_.get()); }
  void deviceLeft();
  void checkProgress(Clock::time_point now);

 private:
  struct Send {
    UsbLink* link;
    Transfer transfer;
    size_t tag;
    enum { kWaiting, kInFlight, kDone } stage = kInFlight;
    LinkStatus status = LinkStatus::kDone;
    LinkStatus whenCancelled = LinkStatus::kCancelled;
  };
  struct Receive {
    UsbLink* link;
    Transfer transfer;
    std::vector<unsigned char> bytes{};
    bool inFlight = false;
  };
  struct ControlRequest {
    UsbLink* link;
    Transfer transfer;
    std::vector<unsigned char> bytes{};
    bool done = false;
  };

  static void LIBUSB_CALL sendDone(libusb_transfer* transfer);
  static void LIBUSB_CALL receiveDone(libusb_transfer* transfer);
  static void LIBUSB_CALL controlDone(libusb_transfer* transfer);

  void shut() noexcept;
  void onSendDone(Send& send);
  void onReceiveDone(Receive& receive);
  std::vector<uint8_t> control(uint8_t type, uint8_t request, uint16_t value, std::span<const uint8_t> out, size_t in);
  // With order_ held.
  bool submit(Send& send);
  void submitWaiting();
  bool submit(Receive& receive);
  // With mutex_ held.
  void cancelSends(LinkStatus as);
  void cancelReceives();
  void cancelRequests();
  size_t sendsInFlight() const;
  bool nothingInFlight() const;

  const std::shared_ptr<Context> context_;
  Handle handle_;  ///< nullptr once closed
  const DisplayInterface display_;
  const wire::LinkDescription description_;
  const std::chrono::milliseconds sendTimeout_;
  const std::chrono::milliseconds requestTimeout_;
  wire::LinkListener listener_;  ///< set once, before anything is in flight that would call it

  std::mutex order_;  ///< transfers reach the device in the order of sends_
  std::mutex mutex_;
  std::condition_variable changed_;
  bool started_ = false;
  bool closed_ = false;
  std::optional<LinkStatus> broken_;
  bool lostReported_ = false;
  std::deque<Send> sends_;
  size_t sendsTaken_ = 0;
  size_t sendsReported_ = 0;
  Clock::time_point lastMove_;
  std::vector<std::unique_ptr<Receive>> receives_;
  std::vector<ControlRequest*> requests_;
  size_t callbacks_ = 0;  ///< of the listener that are running
};

UsbLink::UsbLink(std::shared_ptr<Context> context, Handle handle, const DisplayInterface& display,
                 wire::LinkDescription description, const UsbPortOptions& options)
    : context_(std::move(context)),
      handle_(std::move(handle)),
      display_(display),
      description_(std::move(description)),
      sendTimeout_(options.sendTimeout),
      requestTimeout_(options.requestTimeout) {
  context_->add(this);
}

// --- Requests ---

std::vector<uint8_t> UsbLink::controlIn(uint8_t request, uint16_t value, size_t mostBytes) {
  return control(LIBUSB_ENDPOINT_IN, request, value, {}, mostBytes);
}

void UsbLink::controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) {
  control(LIBUSB_ENDPOINT_OUT, request, value, bytes, 0);
}

void LIBUSB_CALL UsbLink::controlDone(libusb_transfer* transfer) {
  ControlRequest& request = *static_cast<ControlRequest*>(transfer->user_data);
  UsbLink& link = *request.link;
  const std::scoped_lock lock(link.mutex_);
  request.done = true;
  link.changed_.notify_all();
}

// As an asynchronous transfer of its own, so that close() can end it.
std::vector<uint8_t> UsbLink::control(uint8_t type, uint8_t request, uint16_t value, std::span<const uint8_t> out,
                                      size_t in) {
  OC_CHECK(!context_->onEventThread(), "a listener's function must not wait for a request");
  const size_t length = std::max(out.size(), in);
  OC_CHECK(length <= UINT16_MAX, "a control request carries 64 KiB at most");
  ControlRequest state{.link = this, .transfer = newTransfer()};
  state.bytes.resize(LIBUSB_CONTROL_SETUP_SIZE + length);
  libusb_fill_control_setup(state.bytes.data(),
                            static_cast<uint8_t>(type | LIBUSB_REQUEST_TYPE_VENDOR | LIBUSB_RECIPIENT_INTERFACE),
                            request, value, static_cast<uint16_t>(display_.number), static_cast<uint16_t>(length));
  std::ranges::copy(out, state.bytes.begin() + LIBUSB_CONTROL_SETUP_SIZE);
  libusb_fill_control_transfer(state.transfer.get(), handle_.get(), state.bytes.data(), controlDone, &state,
                               static_cast<unsigned>(requestTimeout_.count()));
  const std::string doing = fmt::format("request {} to the display", request);
  {
    const std::scoped_lock order(order_);
    {
      const std::scoped_lock lock(mutex_);
      if (closed_ || broken_) {
        throw LinkError(broken_.value_or(LinkStatus::kCancelled), fmt::format("{}: the link is closed", doing));
      }
      requests_.push_back(&state);
    }
    if (const int error = libusb_submit_transfer(state.transfer.get()); error != 0) {
      const std::scoped_lock lock(mutex_);
      std::erase(requests_, &state);
      changed_.notify_all();
      fail(error, doing);
    }
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return state.done; });
  LinkStatus status = statusOf(state.transfer->status);
  if (status == LinkStatus::kCancelled && broken_) {
    status = *broken_;
  }
  const auto arrived = static_cast<size_t>(state.transfer->actual_length);
  if (status == LinkStatus::kDone && arrived < out.size()) {
    status = LinkStatus::kShort;
  }
  state.transfer.reset();
  std::erase(requests_, &state);
  changed_.notify_all();
  lock.unlock();
  if (status != LinkStatus::kDone) {
    throw LinkError(status, fmt::format("{}: {}", doing, nameOf(status)));
  }
  const auto answer = state.bytes.begin() + LIBUSB_CONTROL_SETUP_SIZE;
  return in == 0 ? std::vector<uint8_t>() : std::vector<uint8_t>(answer, answer + static_cast<ptrdiff_t>(arrived));
}

// --- The stream to the device ---

bool UsbLink::send(size_t tag, std::span<const uint8_t> bytes) {
  OC_CHECK(bytes.size() <= INT32_MAX, "a transfer carries 2 GiB at most");
  const std::scoped_lock order(order_);
  Send* send = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    if (!started_ || closed_ || broken_) {
      return false;
    }
    const bool wait = !sends_.empty() && sends_.back().stage == Send::kWaiting;
    if (sends_.empty()) {
      lastMove_ = Clock::now();
    }
    send = &sends_.emplace_back(Send{.link = this, .transfer = newTransfer(), .tag = tag});
    ++sendsTaken_;
    libusb_fill_bulk_transfer(send->transfer.get(), handle_.get(), display_.out, const_cast<uint8_t*>(bytes.data()),
                              static_cast<int>(bytes.size()), sendDone, send, 0);
    if (wait) {
      send->stage = Send::kWaiting;
      return true;
    }
  }
  return submit(*send);
}

// False where the link turns out to be broken, and the last send is taken back.
bool UsbLink::submit(Send& send) {
  int error = libusb_submit_transfer(send.transfer.get());
  if (error == 0) {
    return true;
  }
  const std::unique_lock lock(mutex_);
  send.stage = Send::kWaiting;
  if (error == LIBUSB_ERROR_NO_MEM) {
    // The system limits what may be under way. Where nothing is, what was there has just come back.
    if (sendsInFlight() > 0) {
      return true;
    }
    send.stage = Send::kInFlight;
    error = libusb_submit_transfer(send.transfer.get());
    if (error == 0) {
      return true;
    }
  }
  broken_ = broken_.value_or(statusOf(error));
  sends_.pop_back();
  --sendsTaken_;
  changed_.notify_all();
  return false;
}

void UsbLink::submitWaiting() {
  for (;;) {
    Send* next = nullptr;
    {
      const std::scoped_lock lock(mutex_);
      const auto waiting = std::ranges::find(sends_, Send::kWaiting, &Send::stage);
      if (waiting == sends_.end() || closed_ || broken_) {
        return;
      }
      next = &*waiting;
      next->stage = Send::kInFlight;
    }
    const int error = libusb_submit_transfer(next->transfer.get());
    if (error != 0) {
      const std::scoped_lock lock(mutex_);
      if (error == LIBUSB_ERROR_NO_MEM && sendsInFlight() > 1) {
        next->stage = Send::kWaiting;
        return;
      }
      // Those that wait will never be sent.
      broken_ = broken_.value_or(statusOf(error));
      for (Send& send : sends_) {
        if (&send == next || send.stage == Send::kWaiting) {
          send.stage = Send::kDone;
          send.status = *broken_;
          send.transfer->actual_length = 0;
        }
      }
      return;
    }
  }
}

void LIBUSB_CALL UsbLink::sendDone(libusb_transfer* transfer) {
  Send& send = *static_cast<Send*>(transfer->user_data);
  send.link->onSendDone(send);
}

void UsbLink::onSendDone(Send& send) {
  std::unique_lock lock(mutex_);
  ++callbacks_;
  send.stage = Send::kDone;
  send.status = statusOf(send.transfer->status);
  if (send.status == LinkStatus::kDone && send.transfer->actual_length < send.transfer->length) {
    send.status = LinkStatus::kShort;
  } else if (send.status == LinkStatus::kCancelled) {
    send.status = send.whenCancelled;
  } else if (send.status == LinkStatus::kGone) {
    broken_ = LinkStatus::kGone;
  }
  lastMove_ = Clock::now();
  lock.unlock();
  {
    const std::scoped_lock order(order_);
    submitWaiting();
  }
  lock.lock();
  // Younger ones may have come back first, when they were cancelled.
  while (!sends_.empty() && sends_.front().stage == Send::kDone) {
    const Send done = std::move(sends_.front());
    sends_.pop_front();
    lock.unlock();
    if (listener_.sent) {
      listener_.sent(done.tag, done.status, static_cast<size_t>(done.transfer->actual_length));
    }
    lock.lock();
    ++sendsReported_;
  }
  --callbacks_;
  changed_.notify_all();
}

size_t UsbLink::sendsInFlight() const {
  return static_cast<size_t>(std::ranges::count(sends_, Send::kInFlight, &Send::stage));
}

// The youngest first: otherwise the device would get the next one in place of one that is cancelled.
void UsbLink::cancelSends(LinkStatus as) {
  for (Send& send : std::views::reverse(sends_)) {
    if (send.stage == Send::kInFlight) {
      send.whenCancelled = as;
      libusb_cancel_transfer(send.transfer.get());
    } else if (send.stage == Send::kWaiting) {
      send.stage = Send::kDone;
      send.status = as;
    }
  }
}

void UsbLink::cancelAll() {
  OC_CHECK(!context_->onEventThread(), "a listener's function must not wait for the link");
  std::unique_lock order(order_);
  std::unique_lock lock(mutex_);
  const size_t last = sendsTaken_;
  cancelSends(LinkStatus::kCancelled);
  order.unlock();  // what is reported may lead to more sends
  changed_.wait(lock, [&] { return sendsReported_ >= last; });
}

void UsbLink::checkProgress(Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  if (sendsInFlight() > 0 && now - lastMove_ > sendTimeout_) {
    lastMove_ = now;
    cancelSends(LinkStatus::kTimedOut);
  }
}

// --- The stream from the device ---

void UsbLink::start(wire::LinkListener listener) {
  const std::scoped_lock order(order_);
  {
    const std::scoped_lock lock(mutex_);
    OC_CHECK(!started_, "a link is started once");
    started_ = true;
    listener_ = std::move(listener);
    for (size_t i = 0; i < kEventTransfers; ++i) {
      Receive& receive =
          *receives_.emplace_back(std::make_unique<Receive>(Receive{.link = this, .transfer = newTransfer()}));
      // A packet each: a longer transfer would hold full packets back until a short one ends it.
      receive.bytes.resize(static_cast<size_t>(display_.inPacketBytes));
      libusb_fill_bulk_transfer(receive.transfer.get(), handle_.get(), display_.in, receive.bytes.data(),
                                display_.inPacketBytes, receiveDone, &receive, 0);
    }
  }
  for (const auto& receive : receives_) {
    if (!submit(*receive)) {
      const std::scoped_lock lock(mutex_);
      throw LinkError(broken_.value_or(LinkStatus::kCancelled), "the display sends no events");
    }
  }
}

bool UsbLink::submit(Receive& receive) {
  {
    const std::scoped_lock lock(mutex_);
    if (closed_ || broken_) {
      return false;
    }
    receive.inFlight = true;
  }
  const int error = libusb_submit_transfer(receive.transfer.get());
  if (error != 0) {
    const std::scoped_lock lock(mutex_);
    receive.inFlight = false;
    broken_ = broken_.value_or(statusOf(error));
  }
  return error == 0;
}

void LIBUSB_CALL UsbLink::receiveDone(libusb_transfer* transfer) {
  Receive& receive = *static_cast<Receive*>(transfer->user_data);
  receive.link->onReceiveDone(receive);
}

void UsbLink::onReceiveDone(Receive& receive) {
  LinkStatus status = statusOf(receive.transfer->status);
  std::optional<LinkStatus> lost;
  {
    const std::scoped_lock lock(mutex_);
    ++callbacks_;
    receive.inFlight = false;
    if (status == LinkStatus::kCancelled && broken_) {
      status = *broken_;
    }
    if (status != LinkStatus::kDone && !closed_) {
      broken_ = broken_.value_or(status);
      lost = status;
    }
  }
  if (status == LinkStatus::kDone) {
    if (receive.transfer->actual_length > 0 && listener_.received) {
      listener_.received({receive.bytes.data(), static_cast<size_t>(receive.transfer->actual_length)});
    }
    const std::scoped_lock order(order_);
    if (!submit(receive)) {
      const std::scoped_lock lock(mutex_);
      lost = closed_ ? std::nullopt : broken_;
    }
  }
  bool report = false;
  if (lost) {
    const std::scoped_lock lock(mutex_);
    report = !std::exchange(lostReported_, true);
    cancelReceives();
  }
  if (report && listener_.lost) {
    listener_.lost(*lost);
  }
  const std::scoped_lock lock(mutex_);
  --callbacks_;
  changed_.notify_all();
}

void UsbLink::cancelReceives() {
  for (const auto& receive : receives_) {
    if (receive->inFlight) {
      libusb_cancel_transfer(receive->transfer.get());
    }
  }
}

// --- The end ---

void UsbLink::deviceLeft() {
  const std::scoped_lock lock(mutex_);
  broken_ = LinkStatus::kGone;
  cancelSends(LinkStatus::kGone);
  cancelReceives();
  cancelRequests();
}

void UsbLink::cancelRequests() {
  for (const ControlRequest* const request : requests_) {
    libusb_cancel_transfer(request->transfer.get());
  }
}

void UsbLink::clearStall() {
  OC_CHECK(!context_->onEventThread(), "a listener's function must not wait for the link");
  const std::scoped_lock order(order_);
  const int error = handle_ ? libusb_clear_halt(handle_.get(), display_.out) : LIBUSB_ERROR_NO_DEVICE;
  if (error != 0) {
    fail(error, "cannot clear the stall of the display");
  }
}

void UsbLink::resetDevice() {
  cancelAll();
  const std::scoped_lock order(order_);
  if (!handle_) {
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    broken_ = broken_.value_or(LinkStatus::kFailed);
    cancelReceives();
  }
  // Where the device comes back as another one, the link does not see it: it is broken in any case.
  libusb_reset_device(handle_.get());
}

bool UsbLink::nothingInFlight() const {
  return sends_.empty() && requests_.empty() && callbacks_ == 0 &&
         std::ranges::none_of(receives_, [](const auto& receive) { return receive->inFlight; });
}

void UsbLink::shut() noexcept {
  OC_CHECK(!context_->onEventThread(), "a listener's function must not close the link");
  {
    const std::scoped_lock order(order_);
    std::unique_lock lock(mutex_);
    if (std::exchange(closed_, true)) {
      return;
    }
    cancelSends(LinkStatus::kCancelled);
    cancelReceives();
    cancelRequests();
  }
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return nothingInFlight(); });
    receives_.clear();
  }
  context_->remove(this);
  const std::scoped_lock order(order_);
  libusb_release_interface(handle_.get(), display_.number);
  handle_.reset();
}

// --- The context ---

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
    for (UsbLink* link : links_) {
      link->checkProgress(Clock::now());
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
  for (UsbLink* link : links_) {
    if (link->device() == device) {
      link->deviceLeft();
    }
  }
}

void Context::add(UsbLink* link) {
  const std::scoped_lock lock(mutex_);
  links_.push_back(link);
}

void Context::remove(UsbLink* link) {
  const std::scoped_lock lock(mutex_);
  std::erase(links_, link);
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

}  // namespace

// --- The port ---

struct UsbPort::State {
  explicit State(UsbPortOptions given) : options(std::move(given)) {}

  const UsbPortOptions options;
  std::shared_ptr<Context> context = std::make_shared<Context>();
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
  for (libusb_device* const device : DeviceList(state_->context->get())) {
    const std::optional<DisplayInterface> display = displayOf(device);
    if (!display) {
      continue;
    }
    try {
      libusb_device_descriptor descriptor{};
      libusb_get_device_descriptor(device, &descriptor);
      Handle handle = openHandle(device);
      const UsbPlace place = placeOf(device);
      wire::LinkDescription description{.serial = stringOf(handle, descriptor.iSerialNumber, "serial"),
                                        .text = describe(place),
                                        .bytesPerSecond = practicalBytesPerSecond(place.speed)};
      if (!state_->options.serial.empty() && description.serial != state_->options.serial) {
        continue;
      }
      claim(handle, *display);
      return std::make_unique<UsbLink>(state_->context, std::move(handle), *display, std::move(description),
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
  Context context;
  std::vector<UsbDisplay> displays;
  for (libusb_device* const device : DeviceList(context.get())) {
    if (!displayOf(device)) {
      continue;
    }
    libusb_device_descriptor descriptor{};
    libusb_get_device_descriptor(device, &descriptor);
    UsbDisplay display;
    display.vendor = descriptor.idVendor;
    display.product = descriptor.idProduct;
    display.link = describe(placeOf(device));
    try {
      const Handle handle = openHandle(device);
      display.serial = stringOf(handle, descriptor.iSerialNumber, "serial");
      display.name = stringOf(handle, descriptor.iProduct, "name");
    } catch (const LinkError& error) {
      display.problem = error.what();
    }
    displays.push_back(std::move(display));
  }
  return displays;
}

size_t usbTransfersAlive() {
  return transfersAlive;
}

}  // namespace ocelli
