#include "display_driver/pacing/device_log_format.h"

#include <algorithm>

#include "display_driver/wire/wire_format.h"

namespace ocelli::device_log {
namespace {

constexpr size_t kChecksumAt = kRecordHeaderBytes - 4;

void store(uint8_t* at, uint64_t value, size_t bytes) {
  for (size_t i = 0; i < bytes; ++i) {
    at[i] = static_cast<uint8_t>(value >> (8 * i));
  }
}

uint64_t load(const uint8_t* at, size_t bytes) {
  uint64_t value = 0;
  for (size_t i = 0; i < bytes; ++i) {
    value |= static_cast<uint64_t>(at[i]) << (8 * i);
  }
  return value;
}

uint32_t checksumOf(std::span<const uint8_t> header, std::span<const uint8_t> payload) {
  return wire::crc32c(payload, wire::crc32c(header.first(kChecksumAt)));
}

}  // namespace

std::array<uint8_t, kHeaderBytes> fileHeader() {
  std::array<uint8_t, kHeaderBytes> bytes{};
  std::ranges::copy(kMagic, bytes.begin());
  store(bytes.data() + 8, kVersion, 4);
  store(bytes.data() + 12, wire::crc32c(std::span(bytes).first(12)), 4);
  return bytes;
}

bool isFileHeader(std::span<const uint8_t> bytes) {
  return std::ranges::equal(bytes, fileHeader());
}

std::array<uint8_t, kRecordHeaderBytes> recordHeader(RecordType type, uint64_t microseconds,
                                                     std::span<const uint8_t> payload) {
  std::array<uint8_t, kRecordHeaderBytes> bytes{};
  store(bytes.data(), kRecordMark, 4);
  store(bytes.data() + 4, static_cast<uint32_t>(type), 4);
  store(bytes.data() + 8, microseconds, 8);
  store(bytes.data() + 16, payload.size(), 4);
  store(bytes.data() + kChecksumAt, checksumOf(bytes, payload), 4);
  return bytes;
}

std::optional<RecordHeader> recordHeaderFrom(std::span<const uint8_t> bytes) {
  if (bytes.size() < kRecordHeaderBytes || load(bytes.data(), 4) != kRecordMark || load(bytes.data() + 20, 4) != 0) {
    return std::nullopt;
  }
  const uint64_t type = load(bytes.data() + 4, 4);
  const RecordHeader header{.type = static_cast<RecordType>(type),
                            .microseconds = load(bytes.data() + 8, 8),
                            .payloadBytes = static_cast<uint32_t>(load(bytes.data() + 16, 4)),
                            .checksum = static_cast<uint32_t>(load(bytes.data() + kChecksumAt, 4))};
  const bool fits = type >= 1 && type <= static_cast<uint64_t>(RecordType::kEnd) &&
                    header.microseconds <= kMaxMicroseconds && header.payloadBytes <= kMaxPayloadBytes;
  return fits ? std::optional(header) : std::nullopt;
}

bool checksumFits(std::span<const uint8_t> header, std::span<const uint8_t> payload) {
  return load(header.data() + kChecksumAt, 4) == checksumOf(header, payload);
}

}  // namespace ocelli::device_log
