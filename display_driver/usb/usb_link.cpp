#include "display_driver/usb/usb_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <ranges>
#include <utility>

#include "display_driver/wire/wire_format.h"
#include "oc_core/base/check.h"

namespace ocelli::usb {

using wire::LinkError;
using wire::LinkStatus;

namespace {

constexpr size_t kEventTransfers = 8;  // waiting for events at the same time

}  // namespace

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

std::vector<uint8_t> UsbLink::controlIn(uint8_t request, uint16_t value, size_t maxBytes) {
  return control(LIBUSB_ENDPOINT_IN, request, value, {}, maxBytes);
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

}  // namespace ocelli::usb
