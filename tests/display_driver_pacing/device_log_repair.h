// Gives the records of a log, and the wire messages in them, checksums that fit: so that changed bytes reach the
// decoders behind the checksums.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "display_driver/pacing/device_log_format.h"
#include "display_driver/wire/wire_format.h"

namespace ocelli::test {

inline void store32(uint32_t value, std::span<uint8_t> bytes) {
  for (size_t i = 0; i < 4; ++i) {
    bytes[i] = static_cast<uint8_t>(value >> (8 * i));
  }
}

/// Of a stream that begins with a message, up to the first one that is not whole.
inline void repairMessages(std::span<uint8_t> stream) {
  constexpr size_t kTypeAt = 4;
  constexpr size_t kPayloadBytesAt = 20;
  constexpr size_t kPayloadChecksumAt = 24;
  constexpr size_t kChecksumAt = 28;
  uint32_t slices = 0;
  uint32_t slicesChecksum = 0;
  while (stream.size() >= wire::kHeaderBytes) {
    uint32_t payloadBytes = 0;
    for (size_t i = 0; i < 4; ++i) {
      payloadBytes |= static_cast<uint32_t>(stream[kPayloadBytesAt + i]) << (8 * i);
    }
    if (payloadBytes > stream.size() - wire::kHeaderBytes) {
      return;
    }
    const std::span<uint8_t> payload = stream.subspan(wire::kHeaderBytes, payloadBytes);
    const auto type = static_cast<wire::MessageType>(stream[kTypeAt]);
    if (type == wire::MessageType::kFrameBegin) {
      slices = slicesChecksum = 0;
    } else if (type == wire::MessageType::kFrameEnd && payload.size() == wire::kFrameEndBytes) {
      store32(slices, payload);
      store32(slicesChecksum, payload.subspan(4));
    }
    store32(wire::crc32c(payload), stream.subspan(kPayloadChecksumAt));
    if (type == wire::MessageType::kSlice) {
      ++slices;
      slicesChecksum = wire::crc32c(stream.subspan(kPayloadChecksumAt, 4), slicesChecksum);
    }
    store32(wire::crc32c(stream.first(kChecksumAt)), stream.subspan(kChecksumAt));
    stream = stream.subspan(wire::kHeaderBytes + payloadBytes);
  }
}

inline void repairDeviceLogChecksums(std::vector<uint8_t>& bytes) {
  if (bytes.size() >= device_log::kHeaderBytes) {
    std::ranges::copy(device_log::fileHeader(), bytes.begin());
  }
  for (size_t at = device_log::kHeaderBytes; at + device_log::kRecordHeaderBytes <= bytes.size();) {
    const auto header = device_log::recordHeaderFrom(std::span(bytes).subspan(at));
    const size_t rest = bytes.size() - at - device_log::kRecordHeaderBytes;
    if (!header || header->payloadBytes > rest) {
      return;
    }
    const std::span<uint8_t> payload =
        std::span(bytes).subspan(at + device_log::kRecordHeaderBytes, header->payloadBytes);
    if (header->type == device_log::RecordType::kStream) {
      repairMessages(payload);
    }
    std::ranges::copy(device_log::recordHeader(header->type, header->microseconds, payload),
                      bytes.begin() + static_cast<std::ptrdiff_t>(at));
    at += device_log::kRecordHeaderBytes + payload.size();
  }
}

}  // namespace ocelli::test
