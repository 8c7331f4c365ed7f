// Puts the volume of a frame together from its messages.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "display_driver/wire/slice_coding.h"
#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/volume.h"

namespace ocelli::wire {

class FrameAssembler {
 public:
  FrameAssembler(const DisplayProfile& profile, uint32_t capabilities);

  /// Begins a frame: `target` gets the slices of `base` (nullptr: dark ones) that are not announced; those that are may
  /// hold anything until they come. Both stay where they are until the frame has ended.
  void begin(const FrameBegin& begin, const Volume* base, Volume& target);
  /// A slice of it. After an error the frame is lost: call drop().
  ErrorCode slice(const MessageHeader& header, std::span<const uint8_t> payload);
  /// kNone: the frame is whole. kIncomplete: the host gave it up; what is there stays for fillGaps().
  ErrorCode end(const FrameEnd& end);
  void drop() { target_ = nullptr; }

  bool active() const { return target_ != nullptr; }
  /// Announced slices that have come.
  uint32_t received() const { return received_; }
  /// Gives slices that have not come what the nearest slice shows that has come or is taken from the base frame. False
  /// where no announced slice has come at all.
  bool fillGaps(Volume& volume) const;

 private:
  SliceDecoder decoder_;
  const Volume* base_ = nullptr;
  Volume* target_ = nullptr;
  std::vector<bool> due_;  ///< announced slices that have not come
  uint32_t received_ = 0;
  uint32_t checksum_ = 0;
};

}  // namespace ocelli::wire
