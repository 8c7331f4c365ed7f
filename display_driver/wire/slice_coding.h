// One slice as the payload of a message, and back (docs/wire_protocol.md, "How slices are coded"). An object works on
// one slice at a time and keeps its buffers; threads have one each.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/bit_planes.h"
#include "display_sim/frames/volume.h"
#include "display_sim/frames/zstd_block.h"

namespace ocelli::wire {

/// Runs of zero bytes and of others in turn: each pair is a count of zero bytes, a count of others, and those.
std::vector<uint8_t> runLengthEncode(std::span<const uint8_t> content);
/// Fills all of `content`; false where the payload does not code `content.size()` bytes.
bool runLengthDecode(std::span<const uint8_t> payload, std::span<uint8_t> content);

struct CodedSlice {
  uint8_t coding = 0;  ///< a Coding, perhaps with kDeltaFlag
  std::vector<uint8_t> payload;
};

/// Which coding is tried first, where a device takes both. Of sliced surfaces zstd makes two thirds of the bytes of run
/// lengths, at two to three times the CPU time.
enum class Effort { kSmall, kFast };

class SliceCoder {
 public:
  /// Uses what a device with these capabilities takes, and raw bytes where nothing makes them fewer.
  explicit SliceCoder(uint32_t capabilities, Effort effort = Effort::kSmall);

  void setEffort(Effort effort) { effort_ = effort; }

  /// `base` holds the slice in the base frame; it is empty where the frame has none. Of the slice and its difference
  /// the one with fewer lit words is taken; where a sample of both tells that the difference has little less, the slice
  /// is, without making the difference.
  CodedSlice encode(std::span<const uint8_t> planes, std::span<const uint8_t> base);

 private:
  uint32_t capabilities_;
  Effort effort_;
  ZstdEncoder zstd_;
  std::vector<uint8_t> difference_;
};

class SliceDecoder {
 public:
  SliceDecoder(const DisplayProfile& profile, uint32_t capabilities);

  /// Fills `planes`; `base` holds the slice in the base frame, and is empty where there is none: then a delta has
  /// nothing to refer to. Trusts nothing. With an error `planes` may hold anything.
  ErrorCode decode(uint8_t coding, std::span<const uint8_t> payload, std::span<const uint8_t> base,
                   std::span<uint8_t> planes);

 private:
  uint32_t capabilities_;
  PaddingCheck padding_;
  ZstdDecoder zstd_;
};

/// The order in which slices are sent: coarse to fine over the angle. Those with the numbers 0, 1/2, 1/4, 3/4, 1/8, ...
/// of their count come first (van der Corput's sequence), so that any first part of a frame covers the whole turn.
std::vector<int> coarseToFineOrder(int slices);

/// Of a frame of which only these slices are there: for each slice the nearest one that is.
std::vector<int> nearestPresent(const std::vector<bool>& present);

}  // namespace ocelli::wire
