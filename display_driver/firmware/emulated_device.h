// An emulated display as its plug sees it: the firmware, behind a link that has a rate and faults. Transports (memory,
// or USB behind umockdev) bring it transfers and requests; it says what becomes of them. It knows no clock and no
// thread: times come from the caller and never go back, and calls come one at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/firmware/fault_script.h"
#include "display_driver/firmware/firmware.h"
#include "oc_core/base/random.h"

namespace ocelli {

struct EmulatedDeviceOptions {
  FirmwareOptions firmware;
  double bytesPerSecond = 0;  ///< of the link; 0: as fast as it goes
  FaultScript faults = {};
};

class EmulatedDevice {
 public:
  explicit EmulatedDevice(EmulatedDeviceOptions options);

  /// False while it is unplugged.
  bool pluggedIn() const { return pluggedIn_; }

  /// nullopt, false: the pipe stalls; requests to an unplugged device are the transport's own affair.
  std::optional<std::vector<uint8_t>> controlIn(uint8_t request, uint16_t value, size_t most, DeviceMicroseconds now);
  bool controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes, DeviceMicroseconds now);

  enum class Outcome {
    kGoOn,   ///< offer the rest of the transfer later
    kShort,  ///< the transfer ends here, with what was taken of it
    kStall,  ///< the pipe halts here
  };
  struct Taken {
    size_t bytes = 0;
    Outcome outcome = Outcome::kGoOn;
  };
  /// Takes bytes of the oldest transfer under way; `rest` are those that were not taken yet. Nothing while the pipe is
  /// halted.
  Taken takeBulk(std::span<const uint8_t> rest, DeviceMicroseconds now);
  bool halted() const { return halted_; }
  void clearHalt() { halted_ = false; }

  /// Whole events, at most `most` bytes; empty where there are none.
  std::vector<uint8_t> takeEvents(size_t most, DeviceMicroseconds now);

  /// Moves everything on: the rotation, and faults that begin or end (pluggedIn() may change).
  void advance(DeviceMicroseconds now);
  /// When the next call may find something new, if nothing else comes: for transports that sleep.
  DeviceMicroseconds nextChange(DeviceMicroseconds now) const;

  Firmware& firmware() { return firmware_; }
  /// Of the script, those that have taken effect so far, and when.
  struct HappenedFault {
    Fault fault;
    DeviceMicroseconds begin = 0;
    DeviceMicroseconds end = 0;  ///< when the device was back; the same as begin for those that do not last
  };
  const std::vector<HappenedFault>& happened() const { return happened_; }
  /// No fault lasts.
  bool quiet() const { return active_.empty(); }

 private:
  struct PendingFault {
    Fault fault;
    std::optional<uint64_t> bytesFrom;  ///< of the stream, when its frame had begun
  };
  bool beginsAfterBytes(const PendingFault& pending) const;
  bool isDue(const PendingFault& pending, DeviceMicroseconds now) const;
  size_t bytesToNextFault(DeviceMicroseconds now) const;
  void begin(const Fault& fault, DeviceMicroseconds now);
  void end(const Fault& fault, DeviceMicroseconds now);
  bool isActive(FaultKind kind) const;
  double rate() const;
  void fillBudget(DeviceMicroseconds now);

  Firmware firmware_;
  double bytesPerSecond_;
  std::vector<PendingFault> pending_;
  struct ActiveFault {
    Fault fault;
    size_t happened = 0;  ///< its place in happened_
    DeviceMicroseconds end = 0;
  };
  std::vector<ActiveFault> active_;
  std::vector<HappenedFault> happened_;
  bool pluggedIn_ = true;
  bool halted_ = false;
  bool shortNext_ = false;
  size_t bitsToFlip_ = 0;
  Random random_;
  uint64_t bytesTaken_ = 0;
  double budget_ = 0;  ///< bytes that the link may carry now
  DeviceMicroseconds budgetTime_ = 0;
};

}  // namespace ocelli
