// Volumes as messages of the bulk stream: what a host sends.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/wire/slice_coding.h"
#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/volume.h"

namespace ocelli::wire {

/// Appends messages of one session to bytes, each with the next sequence number.
class MessageWriter {
 public:
  explicit MessageWriter(uint32_t session) : session_(session) {}

  void frameBegin(std::vector<uint8_t>& out, uint32_t frame, const FrameBegin& begin);
  /// Counts in what frameEnd() tells.
  void slice(std::vector<uint8_t>& out, uint32_t frame, int slice, const CodedSlice& coded);
  void frameEnd(std::vector<uint8_t>& out, uint32_t frame);
  void present(std::vector<uint8_t>& out, uint32_t frame, const Present& present);

 private:
  void append(std::vector<uint8_t>& out, MessageHeader header, std::span<const uint8_t> payload);

  uint32_t session_;
  uint32_t sequence_ = 0;
  FrameEnd end_;
};

/// Codes the slices of frames, several at a time on all threads.
class FrameEncoder {
 public:
  FrameEncoder(const DisplayProfile& profile, uint32_t capabilities);
  ~FrameEncoder();

  /// For the slices that come next.
  void setEffort(Effort effort);

  /// Begins a frame: finds out which slices differ from `base` (nullptr: from darkness). Where `candidates` is given,
  /// other slices are known to be the same. Both volumes stay where they are until the frame is done.
  void begin(const Volume& volume, const Volume* base, std::optional<std::span<const int>> candidates);

  /// What FRAME_BEGIN says of it; the number of the base frame is the caller's.
  const std::vector<bool>& records() const { return records_; }

  struct Coded {
    int slice = 0;
    CodedSlice coded;
  };
  /// The next slices, coarse to fine: at most so many. Empty: the frame is done.
  std::vector<Coded> next(size_t most);
  size_t slicesLeft() const { return left_.size() - at_; }

 private:
  std::vector<int> order_;
  const Volume* volume_ = nullptr;
  const Volume* base_ = nullptr;
  std::vector<bool> records_;
  std::vector<int> left_;  ///< slices to send, in their order
  size_t at_ = 0;
  std::vector<std::unique_ptr<SliceCoder>> coders_;
};

}  // namespace ocelli::wire
