// What goes wrong with an emulated display, and when: a JSON file that `ocelli device emulate --faults` reads
// (docs/emulated_device.md), or drawn at random from a seed.
//
//   {"faults": [{"at_ms": 500, "fault": "stall"},
//               {"at_frame": 20, "fault": "unplug", "for_ms": 300},
//               {"at_ms": 900, "fault": "slow_link", "bytes_per_second": 2000000, "for_ms": 500}]}
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "display_driver/firmware/rotor.h"

namespace ocelli {

enum class FaultKind {
  kStall,          ///< the bulk pipe halts in the middle of a frame
  kShortWrite,     ///< a transfer ends early
  kSlowLink,       ///< so many bytes a second for a while
  kUnplug,         ///< in the middle of a frame; plugged in again after a while
  kWrongSequence,  ///< the device takes a message for another one than it is: it seems to be missing one
  kBitFlips,       ///< so many bits of the stream change on the way
  kPhaseDrift,     ///< the motor runs at another rate for a while
  kFullBuffers,    ///< the device takes nothing for a while
  kDeafControl,    ///< requests of the control pipe fail for a while
};
inline constexpr size_t kFaultKinds = 9;

/// The name in a script: "stall", "short_write", "slow_link", "unplug", "wrong_sequence", "bit_flips", "phase_drift",
/// "full_buffers", "deaf_control".
const char* nameOf(FaultKind kind);

struct Fault {
  FaultKind kind = FaultKind::kStall;
  /// When: at this time after the start, and once this many frames have begun and so many bytes of the stream of the
  /// frame then under way have come.
  DeviceMicroseconds at = 0;
  uint32_t afterFrames = 0;
  size_t afterBytes = 0;
  DeviceMicroseconds duration = 0;  ///< of faults that last
  double amount = 0;                ///< bytes a second, bits, or the rate of the motor: what the kind needs

  bool operator==(const Fault&) const = default;
};

struct FaultScript {
  std::vector<Fault> faults;  ///< each takes effect once

  bool operator==(const FaultScript&) const = default;
};

/// Throws InputError naming fault and field.
FaultScript faultScriptFromJson(const std::string& text, const std::string& where);
FaultScript readFaultScript(const std::filesystem::path& path);
std::string jsonText(const FaultScript& script);

/// So many faults of all kinds, over so long a time; the same seed gives the same ones.
FaultScript randomFaults(uint64_t seed, size_t count, DeviceMicroseconds over);

}  // namespace ocelli
