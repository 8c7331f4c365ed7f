#include "display_sim/frames/svol_format.h"

#include <zlib.h>

#include "display_sim/frames/volume.h"
#include "oc_core/base/check.h"

namespace ocelli::svol {
namespace {

void append32(std::vector<uint8_t>& bytes, uint32_t value) {
  bytes.resize(bytes.size() + 4);
  store32(bytes.data() + bytes.size() - 4, value);
}

void append64(std::vector<uint8_t>& bytes, uint64_t value) {
  append32(bytes, static_cast<uint32_t>(value));
  append32(bytes, static_cast<uint32_t>(value >> 32));
}

/// Of all bytes from `begin` on.
void appendChecksum(std::vector<uint8_t>& bytes, size_t begin = 0) {
  append32(bytes, checksum(std::span<const uint8_t>(bytes).subspan(begin)));
}

}  // namespace

uint32_t checksum(std::span<const uint8_t> bytes) {
  return static_cast<uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

std::vector<uint8_t> headerRecord(const DisplayProfile& profile, const std::string& metadata) {
  const std::string profileText = jsonText(profile);
  OC_CHECK(profileText.size() <= kMaxProfileBytes && metadata.size() <= kMaxMetadataBytes, "the texts are too long");
  std::vector<uint8_t> bytes(kMagic.begin(), kMagic.end());
  append32(bytes, kVersion);
  append32(bytes, static_cast<uint32_t>(profileText.size()));
  append32(bytes, static_cast<uint32_t>(metadata.size()));
  append32(bytes, static_cast<uint32_t>(profile.storedSlices()));
  append32(bytes, static_cast<uint32_t>(profile.width));
  append32(bytes, static_cast<uint32_t>(profile.height));
  append32(bytes, static_cast<uint32_t>(profile.colorBitsPerChannel));
  bytes.insert(bytes.end(), profileText.begin(), profileText.end());
  bytes.insert(bytes.end(), metadata.begin(), metadata.end());
  appendChecksum(bytes);
  return bytes;
}

std::vector<uint8_t> frameRecordHead(const FrameHead& head) {
  std::vector<uint8_t> bytes;
  bytes.reserve(frameHeadBytes(head.slices.size()));
  uint32_t payloadBytes = 0;
  for (const SliceEntry& slice : head.slices) {
    payloadBytes += slice.bytes;
  }
  append32(bytes, kFrameMark);
  append32(bytes, head.number);
  append64(bytes, head.timeMicroseconds);
  append32(bytes, head.key ? 0 : 1);
  append32(bytes, payloadBytes);
  for (const SliceEntry& slice : head.slices) {
    append32(bytes, slice.bytes << 2 | static_cast<uint32_t>(slice.kind));
    append32(bytes, slice.checksum);
  }
  appendChecksum(bytes);
  return bytes;
}

std::vector<uint8_t> indexAndEnd(std::span<const SvolFrame> frames, uint64_t offset) {
  std::vector<uint8_t> bytes;
  append32(bytes, kIndexMark);
  append32(bytes, static_cast<uint32_t>(frames.size()));
  for (const SvolFrame& frame : frames) {
    append64(bytes, frame.offset);
    append64(bytes, frame.timeMicroseconds);
    append32(bytes, frame.key ? 0 : 1);
  }
  appendChecksum(bytes);
  const size_t end = bytes.size();
  append32(bytes, kEndMark);
  append64(bytes, offset);
  appendChecksum(bytes, end);
  return bytes;
}

}  // namespace ocelli::svol
