// A link to a display over USB: bulk transfers for the stream, control transfers for requests.
//
// Completions come on the event thread of the context; from it the listener is called, with no lock held. Everything
// else is called by users' threads. Locks, in the order in which they are taken: that of the context, order_, mutex_.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "display_driver/usb/usb_context.h"
#include "display_driver/usb/usb_handles.h"
#include "display_driver/usb/usb_port.h"

namespace ocelli::usb {

class UsbLink final : public wire::Link, public EventTarget {
 public:
  using Clock = std::chrono::steady_clock;

  /// `handle` has claimed the display.
  UsbLink(std::shared_ptr<Context> context, Handle handle, const DisplayInterface& display,
          wire::LinkDescription description, const UsbPortOptions& options);
  ~UsbLink() override { shut(); }

  const wire::LinkDescription& description() const override { return description_; }
  std::vector<uint8_t> controlIn(uint8_t request, uint16_t value, size_t maxBytes) override;
  void controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) override;
  void start(wire::LinkListener listener) override;
  bool send(size_t tag, std::span<const uint8_t> bytes) override;
  void cancelAll() override;
  void clearStall() override;
  void resetDevice() override;
  void close() override { shut(); }

  libusb_device* device() const override { return libusb_get_device(handle_.get()); }
  void deviceLeft() override;
  void checkProgress(Clock::time_point now) override;

 private:
  using LinkStatus = wire::LinkStatus;
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

}  // namespace ocelli::usb
