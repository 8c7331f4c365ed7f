// Where a multivox device puts its cells: the shared memory of a display on this machine (multivox_memory.h), or a
// display on the network (multivox_network.h). For one thread at a time, except stop().
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace ocelli {

/// What the display's driver tells.
struct MultivoxStatus {
  int shownPage = 0;
  int bitsPerChannel = 0;                  ///< 1 to 3; 0 where nobody has set it
  int revolutionsPerMinute = 0;            ///< 0 while it stands still, and from those that do not tell
  std::chrono::microseconds frameTime{0};  ///< for one pass over the panel's lines; 0: not known
};

class MultivoxTarget {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kMinRest{20};

  virtual ~MultivoxTarget() = default;

  virtual std::string name() const = 0;
  virtual std::string link() const = 0;  ///< for people

  enum class Found {
    kNothing,  ///< no display, or none that can be used: problem() says why
    kNew,      ///< one that was not there at the last look; what was written before is not in it
    kSame,
  };
  virtual Found look() = 0;

  /// These are for after a look() that found a display. They return false, or nothing, where it is no longer there.
  virtual std::optional<MultivoxStatus> status() const = 0;
  /// Makes a frame ready, which must not be before rested().
  virtual bool write(std::span<const uint8_t> cells) = 0;
  /// Shows the frame that was written last.
  virtual bool show() = 0;
  /// From when on write() may be called.
  virtual Clock::time_point rested() const = 0;
  /// Whether a frame leaves this machine with show(), and not with write().
  virtual bool sendsWhenShown() const { return false; }

  virtual size_t frameBytes() const = 0;   ///< of the frame that was written last
  virtual uint64_t bytesSent() const = 0;  ///< since the beginning
  /// For people: why there is no display, or what disturbs; empty where all is well.
  virtual const std::string& problem() const = 0;
  /// Any thread may call it: what waits returns soon, and waits no more.
  virtual void stop() {}
};

}  // namespace ocelli
