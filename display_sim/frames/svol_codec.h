// One slice of a `.svol` frame: from bit planes to a compressed payload and back.
//
// An object works on one slice at a time and keeps its buffers; threads have one each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "display_sim/frames/bit_planes.h"
#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/volume.h"
#include "display_sim/frames/zstd_block.h"

namespace ocelli::svol {

/// Slices that a thread codes at a time: enough work for a compressor of its own.
inline constexpr size_t kSlicesPerRange = 4;

struct EncodedSlice {
  SliceEntry entry;
  std::vector<uint8_t> payload;
};

class SliceEncoder {
 public:
  /// `before` holds the slice in the frame before; it is empty where a key frame is written. Of whole and delta the one
  /// with fewer lit words is taken: sparse planes cost about what is lit in them.
  EncodedSlice encode(std::span<const uint8_t> planes, std::span<const uint8_t> before);

 private:
  EncodedSlice compress(SvolSliceKind kind, std::span<const uint8_t> planes);

  ZstdEncoder zstd_;
  std::vector<uint8_t> difference_;
};

class SliceDecoder {
 public:
  explicit SliceDecoder(const DisplayProfile& profile);

  struct Result {
    std::string problem;   ///< empty where there is none; else `planes` may hold anything
    bool changed = false;  ///< `planes` differs from what it was before
  };
  /// Brings `planes`, which hold the slice of the frame before, to this frame. Trusts neither entry nor payload.
  Result apply(const SliceEntry& entry, std::span<const uint8_t> payload, std::span<uint8_t> planes);

 private:
  std::string decompress(const SliceEntry& entry, std::span<const uint8_t> payload);

  ZstdDecoder zstd_;
  VolumeLayout layout_;
  PaddingCheck padding_;
  std::vector<uint8_t> decoded_;
};

}  // namespace ocelli::svol
