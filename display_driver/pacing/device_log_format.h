// The bytes of device logs as their writer, their reader and their tests share them (docs/device_log.md
// says all of it). All numbers are little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "display_driver/wire/wire_format.h"

namespace ocelli::device_log {

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'O', 'S', 'E', 'S', '\r', '\n', 0x1a};
inline constexpr uint32_t kVersion = 1;
inline constexpr size_t kHeaderBytes = 16;

inline constexpr uint32_t kRecordMark = 0x44434552;  ///< "RECD"
inline constexpr size_t kRecordHeaderBytes = 28;
/// Of a record; longer streams go into several.
inline constexpr size_t kMaxPayloadBytes = size_t{1} << 20;
/// 285 years, which a double still counts exactly.
inline constexpr uint64_t kMaxMicroseconds = (uint64_t{1} << 53) - 1;
/// The log number of the wire messages in it.
inline constexpr uint32_t kWireSession = 1;
/// How its slices may be coded.
inline constexpr uint32_t kWireCapabilities = wire::kCanRunLength | wire::kCanZstd | wire::kCanDelta;

enum class RecordType : uint32_t {
  kOpening = 1,    ///< JSON: what was recorded, and from which device. The first one
  kStream = 2,     ///< messages of the wire protocol, which go on in the next one
  kFate = 3,       ///< JSON: what became of a frame
  kTelemetry = 4,  ///< JSON
  kEnd = 5,        ///< nothing: the log was closed
};

struct RecordHeader {
  RecordType type = RecordType::kEnd;
  uint64_t microseconds = 0;  ///< since the opening; never decreases
  uint32_t payloadBytes = 0;
  uint32_t checksum = 0;  ///< CRC-32C of the header before it, and the payload
};

std::array<uint8_t, kHeaderBytes> fileHeader();
bool isFileHeader(std::span<const uint8_t> bytes);
/// With its checksum.
std::array<uint8_t, kRecordHeaderBytes> recordHeader(RecordType type, uint64_t microseconds,
                                                     std::span<const uint8_t> payload);
/// nullopt where these bytes begin no record; whether the checksum is right only the payload tells.
std::optional<RecordHeader> recordHeaderFrom(std::span<const uint8_t> bytes);
bool checksumFits(std::span<const uint8_t> header, std::span<const uint8_t> payload);

}  // namespace ocelli::device_log
