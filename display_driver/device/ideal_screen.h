// A screen that turns without any error, and which frame it shows when: for devices that are no hardware. It knows no
// clock: who calls it says what time it is, and never an earlier time than before.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/device/device.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

class IdealRotation {
 public:
  /// Refresh 0 begins at `start`.
  IdealRotation(const DisplayProfile& profile, HostTime start);

  /// HostTime::max() for what lies further ahead than a clock counts.
  HostTime timeOf(const RotationPhase& phase) const;
  /// The first slice that begins at this time or later; before the start, slice 0 of refresh 0.
  RotationPhase next(HostTime time) const;
  /// The same among those with this number.
  RotationPhase next(HostTime time, int slice) const;
  RotationReading reading(HostTime time) const;

 private:
  double slicesSince(HostTime time) const;

  HostTime start_;
  int slices_;
  double refreshNanoseconds_;
};

class IdealScreen {
 public:
  /// Frames that wait beside the one that is shown.
  static constexpr size_t kMaxWaiting = 3;

  IdealScreen(const DisplayProfile& profile, HostTime start) : rotation_(profile, start) {}

  const IdealRotation& rotation() const { return rotation_; }

  struct Frame {
    std::shared_ptr<FrameFence> fence;
    std::shared_ptr<const Volume> volume;  ///< nullptr where nobody wants it
    FrameState state;
    std::optional<Presentation> presentation;
    HostTime due = HostTime::max();  ///< when it is shown; max: nobody has said
  };
  /// The frame is there. Where too many wait, the oldest without a time gives way, else the newest.
  void add(Frame frame, HostTime now);
  void present(FrameNumber frame, const Presentation& presentation, HostTime now);
  /// Those that have been shown up to now, in their order; their fences are not moved yet.
  std::vector<Frame> advance(HostTime now);
  /// When advance() has something to show; max: never.
  HostTime nextChange() const;
  /// All frames that wait, in the order of their numbers.
  std::vector<Frame> takeWaiting();

  /// Frames that gave way to newer ones; their fences say so.
  uint64_t dropped() const { return dropped_; }
  /// Refreshes that had to show an old frame.
  uint64_t underruns() const { return underruns_; }

 private:
  void drop(size_t waiting);

  IdealRotation rotation_;
  std::vector<Frame> waiting_;  ///< in the order of their numbers
  uint64_t dropped_ = 0;
  uint64_t underruns_ = 0;
};

}  // namespace ocelli
