// One slice of a `.svol` frame: from bit planes to a compressed payload and back.
//
// An object works on one slice at a time and keeps its buffers; threads have one each.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "display_sim/frames/svol_format.h"
#include "display_sim/frames/volume.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace ocelli::svol {

struct EncodedSlice {
  SliceEntry entry;
  std::vector<uint8_t> payload;
};

class SliceEncoder {
 public:
  SliceEncoder();

  /// `before` holds the slice in the frame before; it is empty where a key frame is written. Of whole and delta the one
  /// with fewer lit words is taken: sparse planes cost about what is lit in them.
  EncodedSlice encode(std::span<const uint8_t> planes, std::span<const uint8_t> before);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };
  EncodedSlice compress(SvolSliceKind kind, std::span<const uint8_t> planes);

  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
  std::vector<uint8_t> difference_;
  std::vector<uint8_t> compressed_;
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
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const;
  };
  std::string decompress(const SliceEntry& entry, std::span<const uint8_t> payload);

  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
  VolumeLayout layout_;
  uint8_t paddingMask_;  ///< the bits of a row's last byte that lie beyond the width
  std::vector<uint8_t> decoded_;
};

}  // namespace ocelli::svol
