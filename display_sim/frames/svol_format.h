// The bytes of the `.svol` format as its writer, its reader and their tests share them (docs/svol.md says all of it).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"

namespace ocelli {

/// How a frame holds one slice.
enum class SvolSliceKind : uint32_t {
  kDark,       ///< no light at all
  kWhole,      ///< the bit planes, compressed
  kDelta,      ///< the bits that differ from the frame before, compressed
  kUnchanged,  ///< as in the frame before
};
inline constexpr size_t kSvolSliceKinds = 4;

/// Where a frame lies in the file and when it is shown.
struct SvolFrame {
  uint64_t offset = 0;
  uint64_t timeMicroseconds = 0;
  bool key = false;  ///< needs no frame before it

  bool operator==(const SvolFrame&) const = default;
};

namespace svol {

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'S', 'V', 'O', 'L', '\r', '\n', 0x1a};
inline constexpr uint32_t kVersion = 1;
inline constexpr uint32_t kFrameMark = 0x4d415246;  ///< "FRAM"
inline constexpr uint32_t kIndexMark = 0x58444e49;  ///< "INDX"
inline constexpr uint32_t kEndMark = 0x454e4f44;    ///< "DONE"

inline constexpr size_t kHeaderBytes = 36;  ///< before the texts
inline constexpr size_t kMaxProfileBytes = size_t{1} << 16;
inline constexpr size_t kMaxMetadataBytes = size_t{1} << 20;
inline constexpr size_t kChecksumBytes = 4;
inline constexpr size_t kFrameFieldBytes = 24;  ///< before the slice table
inline constexpr size_t kSliceEntryBytes = 8;
inline constexpr size_t kIndexFieldBytes = 8;  ///< before the entries
inline constexpr size_t kIndexEntryBytes = 20;
inline constexpr size_t kEndBytes = 16;
/// Of times: 285 years, which a double still counts exactly.
inline constexpr uint64_t kMaxMicroseconds = (uint64_t{1} << 53) - 1;
inline constexpr uint32_t kMaxSliceBytes = (1u << 30) - 1;  ///< of a compressed slice: the table's field is that wide

/// A line of a frame's slice table.
struct SliceEntry {
  SvolSliceKind kind = SvolSliceKind::kDark;
  uint32_t bytes = 0;     ///< of the compressed payload; 0 where the kind has none
  uint32_t checksum = 0;  ///< of these; 0 where the kind has none
};

inline bool hasPayload(SvolSliceKind kind) {
  return kind == SvolSliceKind::kWhole || kind == SvolSliceKind::kDelta;
}

/// What stands before the payloads of a frame.
struct FrameHead {
  uint32_t number = 0;
  uint64_t timeMicroseconds = 0;
  bool key = false;
  std::vector<SliceEntry> slices;
};

constexpr size_t frameHeadBytes(size_t slices) {
  return kFrameFieldBytes + slices * kSliceEntryBytes + kChecksumBytes;
}
constexpr size_t indexBytes(size_t frames) {
  return kIndexFieldBytes + frames * kIndexEntryBytes + kChecksumBytes;
}

inline void store32(uint8_t* at, uint32_t value) {
  for (int i = 0; i < 4; ++i) {
    at[i] = static_cast<uint8_t>(value >> (8 * i));
  }
}
inline uint32_t load32(const uint8_t* at) {
  return at[0] | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
         static_cast<uint32_t>(at[3]) << 24;
}
inline uint64_t load64(const uint8_t* at) {
  return load32(at) | static_cast<uint64_t>(load32(at + 4)) << 32;
}

/// CRC-32 of ISO 3309 (that of zlib and PNG).
uint32_t checksum(std::span<const uint8_t> bytes);

/// The records of a file as their bytes. The texts are JSON.
std::vector<uint8_t> headerRecord(const DisplayProfile& profile, const std::string& metadata);
std::vector<uint8_t> frameRecordHead(const FrameHead& head);
/// The index and the end record after it; `offset` is where they go.
std::vector<uint8_t> indexAndEnd(std::span<const SvolFrame> frames, uint64_t offset);

}  // namespace svol
}  // namespace ocelli
