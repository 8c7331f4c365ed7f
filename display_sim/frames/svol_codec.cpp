#include "display_sim/frames/svol_codec.h"

#include <algorithm>

#include "display_sim/frames/bit_planes.h"
#include "oc_core/base/check.h"

namespace ocelli::svol {

EncodedSlice SliceEncoder::compress(SvolSliceKind kind, std::span<const uint8_t> planes) {
  const std::span<const uint8_t> payload = zstd_.compress(planes);
  OC_CHECK(payload.size() <= kMaxSliceBytes, "the display profile was not validated");
  return {{kind, static_cast<uint32_t>(payload.size()), checksum(payload)}, {payload.begin(), payload.end()}};
}

EncodedSlice SliceEncoder::encode(std::span<const uint8_t> planes, std::span<const uint8_t> before) {
  if (before.empty()) {
    return isDark(planes) ? EncodedSlice{} : compress(SvolSliceKind::kWhole, planes);
  }
  if (areEqual(planes, before)) {
    return {{SvolSliceKind::kUnchanged, 0, 0}, {}};
  }
  difference_.resize(planes.size());
  const WordCounts words = subtract(planes, before, difference_);
  if (words.lit == 0) {
    return {};
  }
  return words.changed < words.lit ? compress(SvolSliceKind::kDelta, difference_)
                                   : compress(SvolSliceKind::kWhole, planes);
}

SliceDecoder::SliceDecoder(const DisplayProfile& profile) : layout_(profile), padding_(profile) {}

std::string SliceDecoder::decompress(const SliceEntry& entry, std::span<const uint8_t> payload) {
  if (checksum(payload) != entry.checksum) {
    return "the checksum is wrong";
  }
  decoded_.resize(layout_.sliceBytes);
  if (!zstd_.decompress(payload, decoded_)) {
    return "its bytes are not one zstd frame of " + std::to_string(layout_.sliceBytes) + " bytes";
  }
  return padding_.holds(decoded_) ? "" : "a bit beyond the width is set";
}

SliceDecoder::Result SliceDecoder::apply(const SliceEntry& entry, std::span<const uint8_t> payload,
                                         std::span<uint8_t> planes) {
  if (hasPayload(entry.kind)) {
    std::string problem = decompress(entry, payload);
    if (!problem.empty()) {
      return {std::move(problem), false};
    }
  }
  bool changed = false;
  switch (entry.kind) {
    case SvolSliceKind::kDark:
      changed = !isDark(planes);
      if (changed) {
        std::ranges::fill(planes, uint8_t{0});
      }
      break;
    case SvolSliceKind::kWhole:
      changed = !areEqual(planes, decoded_);
      if (changed) {
        std::ranges::copy(decoded_, planes.begin());
      }
      break;
    case SvolSliceKind::kDelta:
      changed = !isDark(decoded_);
      addDifference(planes, decoded_);
      break;
    case SvolSliceKind::kUnchanged:
      break;
  }
  return {{}, changed};
}

}  // namespace ocelli::svol
