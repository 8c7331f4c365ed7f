// The way bytes travel between the host and a display that speaks the wire protocol (docs/wire_protocol.md), whatever
// carries them: USB, or memory where the display is simulated in the same process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace ocelli::wire {

enum class LinkStatus {
  kDone,       ///< all bytes have gone
  kShort,      ///< only a part has
  kStalled,    ///< the device refuses more until clearStall()
  kTimedOut,   ///< nothing moved for the link's time-out
  kCancelled,  ///< by cancelAll() or close()
  kGone,       ///< the device has been unplugged
  kFailed,
};
const char* nameOf(LinkStatus status);

/// A request or a transfer failed.
class LinkError : public std::runtime_error {
 public:
  LinkError(LinkStatus status, const std::string& what) : std::runtime_error(what), status_(status) {}
  LinkStatus status() const { return status_; }

 private:
  LinkStatus status_;
};

struct LinkDescription {
  std::string serial;         ///< empty where the device has none
  std::string text;           ///< for people: "USB 2, 480 Mbit/s, bus 1 port 2"
  double bytesPerSecond = 0;  ///< that the kind of link can carry in practice; 0: not known
};

/// What a link calls, on a thread of its own. The functions may call send(); nothing else of the link.
struct LinkListener {
  /// The bytes of a send() are no longer needed. Comes once for each send(), in their order.
  std::function<void(size_t tag, LinkStatus status, size_t bytes)> sent;
  /// Bytes that the device sent (its events).
  std::function<void(std::span<const uint8_t> bytes)> received;
  /// The stream of events has broken; comes at most once. No bytes are received any more.
  std::function<void(LinkStatus status)> lost;
};

/// An open connection. Everything that was sent is on its way at the same time, in order.
class Link {
 public:
  virtual ~Link() = default;  ///< as close()

  virtual const LinkDescription& description() const = 0;

  /// Vendor requests of the control pipe; wait for the answer. Throw LinkError.
  virtual std::vector<uint8_t> controlIn(uint8_t request, uint16_t value, size_t maxBytes) = 0;
  virtual void controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes) = 0;

  /// Starts to listen. Call it once.
  virtual void start(LinkListener listener) = 0;
  /// Sends bytes, which must stay where they are until `sent` comes with this tag. Does not wait. False where the link
  /// is broken or closed: `sent` does not come then.
  virtual bool send(size_t tag, std::span<const uint8_t> bytes) = 0;
  /// Cancels all that was sent and waits until `sent` has come for each. Not from a listener's function.
  virtual void cancelAll() = 0;
  /// After kStalled. Throws LinkError.
  virtual void clearStall() = 0;
  /// Resets the device's side of the link as a whole: for devices that no longer answer. The link is broken then; open
  /// it anew.
  virtual void resetDevice() = 0;
  /// Cancels everything, waits for it and frees the device. No function of the listener is called after it. Not from a
  /// listener's function.
  virtual void close() = 0;
};

/// Where links to one device come from, again and again: it may be unplugged and come back.
class LinkPort {
 public:
  virtual ~LinkPort() = default;

  /// What it looks for, for messages: "a display on USB", "the display with the serial 12".
  virtual std::string description() const = 0;
  /// Throws LinkError: kGone where there is no such device, else what stands in the way (rights, another program).
  virtual std::unique_ptr<Link> open() = 0;
  /// Returns when a device may have come, and after this time at the latest. wake() ends it early.
  virtual void waitForArrival(std::chrono::milliseconds timeout) = 0;
  /// From any thread.
  virtual void wake() = 0;
};

}  // namespace ocelli::wire
