#include "display_sim/frames/svol_codec.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <new>

#include "oc_core/base/check.h"

namespace ocelli::svol {
namespace {

/// The default, 3, takes as long and writes as much; from 4 on it takes more than twice as long for a few percent.
constexpr int kCompressionLevel = 1;

bool isDark(std::span<const uint8_t> planes) {
  return planes.front() == 0 && std::memcmp(planes.data(), planes.data() + 1, planes.size() - 1) == 0;
}

bool areEqual(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  return std::memcmp(a.data(), b.data(), a.size()) == 0;
}

struct WordCounts {
  uint32_t lit = 0;
  uint32_t changed = 0;
};

/// Fills `difference` with a XOR b, and counts the words of a and of `difference` that are not 0.
WordCounts subtract(std::span<const uint8_t> a, std::span<const uint8_t> b, std::span<uint8_t> difference) {
  WordCounts counts;
  // Words of four bytes, which compilers compare several at a time.
  const auto step = [&](size_t at, size_t bytes) {
    uint32_t wordOfA = 0;
    uint32_t wordOfB = 0;
    std::memcpy(&wordOfA, a.data() + at, bytes);
    std::memcpy(&wordOfB, b.data() + at, bytes);
    const uint32_t change = wordOfA ^ wordOfB;
    std::memcpy(difference.data() + at, &change, bytes);
    counts.lit += wordOfA != 0 ? 1 : 0;
    counts.changed += change != 0 ? 1 : 0;
  };
  const size_t whole = a.size() / sizeof(uint32_t) * sizeof(uint32_t);
  for (size_t at = 0; at < whole; at += sizeof(uint32_t)) {
    step(at, sizeof(uint32_t));
  }
  if (whole < a.size()) {
    step(whole, a.size() - whole);
  }
  return counts;
}

}  // namespace

void SliceEncoder::Free::operator()(ZSTD_CCtx_s* context) const {
  ZSTD_freeCCtx(context);
}

SliceEncoder::SliceEncoder() : context_(ZSTD_createCCtx()) {
  if (!context_) {
    throw std::bad_alloc();
  }
}

EncodedSlice SliceEncoder::compress(SvolSliceKind kind, std::span<const uint8_t> planes) {
  compressed_.resize(ZSTD_compressBound(planes.size()));
  const size_t size = ZSTD_compressCCtx(context_.get(), compressed_.data(), compressed_.size(), planes.data(),
                                        planes.size(), kCompressionLevel);
  OC_CHECK(ZSTD_isError(size) == 0, "zstd refused a buffer of the size that it asked for");
  OC_CHECK(size <= kMostSliceBytes, "the display profile was not validated");
  const std::span<const uint8_t> payload = std::span(compressed_).first(size);
  return {{kind, static_cast<uint32_t>(size), checksum(payload)}, {payload.begin(), payload.end()}};
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

void SliceDecoder::Free::operator()(ZSTD_DCtx_s* context) const {
  ZSTD_freeDCtx(context);
}

SliceDecoder::SliceDecoder(const DisplayProfile& profile)
    : context_(ZSTD_createDCtx()),
      layout_(profile),
      paddingMask_(static_cast<uint8_t>(profile.width % 8 == 0 ? 0 : 0xff << (profile.width % 8))) {
  if (!context_) {
    throw std::bad_alloc();
  }
}

std::string SliceDecoder::decompress(const SliceEntry& entry, std::span<const uint8_t> payload) {
  if (checksum(payload) != entry.checksum) {
    return "the checksum is wrong";
  }
  decoded_.resize(layout_.sliceBytes);
  if (ZSTD_findFrameCompressedSize(payload.data(), payload.size()) != payload.size() ||
      ZSTD_getFrameContentSize(payload.data(), payload.size()) != layout_.sliceBytes ||
      ZSTD_decompressDCtx(context_.get(), decoded_.data(), decoded_.size(), payload.data(), payload.size()) !=
          layout_.sliceBytes) {
    return "its bytes are not one zstd frame of " + std::to_string(layout_.sliceBytes) + " bytes";
  }
  for (size_t last = layout_.rowBytes - 1; paddingMask_ != 0 && last < decoded_.size(); last += layout_.rowBytes) {
    if ((decoded_[last] & paddingMask_) != 0) {
      return "a bit beyond the width is set";
    }
  }
  return {};
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
      std::ranges::transform(planes, decoded_, planes.begin(),
                             [](uint8_t a, uint8_t b) { return static_cast<uint8_t>(a ^ b); });
      break;
    case SvolSliceKind::kUnchanged:
      break;
  }
  return {{}, changed};
}

}  // namespace ocelli::svol
