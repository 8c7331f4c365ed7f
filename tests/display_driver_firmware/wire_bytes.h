// The bytes of the wire protocol, written and read from docs/wire_protocol.md alone: nothing here is shared with
// display_driver/, so that tests compare two readings of the page.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ocelli::test {

using Bytes = std::vector<uint8_t>;
using ByteSpan = std::span<const uint8_t>;

inline uint64_t number(ByteSpan bytes, size_t at, size_t count) {
  uint64_t value = 0;
  for (size_t i = count; i-- > 0;) {
    value = value << 8 | bytes[at + i];
  }
  return value;
}
inline uint16_t u16(ByteSpan bytes, size_t at) {
  return static_cast<uint16_t>(number(bytes, at, 2));
}
inline uint32_t u32(ByteSpan bytes, size_t at) {
  return static_cast<uint32_t>(number(bytes, at, 4));
}
inline uint64_t u64(ByteSpan bytes, size_t at) {
  return number(bytes, at, 8);
}

inline void put(Bytes& bytes, uint64_t value, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
  }
}
inline void append(Bytes& bytes, ByteSpan more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

/// CRC-32C, four bits at a time.
inline uint32_t checksum(ByteSpan bytes) {
  static const auto kTable = [] {
    std::vector<uint32_t> table;
    for (uint32_t i = 0; i < 16; ++i) {
      uint32_t value = i;
      for (int bit = 0; bit < 4; ++bit) {
        value = (value >> 1) ^ (0x82f63b78u & (0u - (value & 1)));
      }
      table.push_back(value);
    }
    return table;
  }();
  uint32_t sum = 0xffffffff;
  for (const uint8_t byte : bytes) {
    sum ^= byte;
    sum = (sum >> 4) ^ kTable[sum & 15];
    sum = (sum >> 4) ^ kTable[sum & 15];
  }
  return ~sum;
}
inline void putChecksum(Bytes& bytes) {
  put(bytes, checksum(bytes), 4);
}
/// Records end with the checksum of what is before it.
inline bool isWholeRecord(ByteSpan bytes) {
  return bytes.size() >= 4 && checksum(bytes.first(bytes.size() - 4)) == u32(bytes, bytes.size() - 4);
}

constexpr uint8_t kFrameBegin = 1;
constexpr uint8_t kSlice = 2;
constexpr uint8_t kFrameEnd = 3;
constexpr uint8_t kPresent = 4;

constexpr uint8_t kRaw = 0;
constexpr uint8_t kRunLength = 1;
constexpr uint8_t kZstd = 2;
constexpr uint8_t kDifference = 128;

constexpr uint16_t kAtNextRefresh = 1;
constexpr uint16_t kTearWhenLate = 2;
constexpr uint16_t kCoarseWhenLate = 4;

constexpr uint8_t kLate = 1;
constexpr uint8_t kCoarse = 2;
constexpr uint8_t kTorn = 4;

inline Bytes armRecord(uint32_t session, uint16_t majorVersion = 1, uint16_t minorVersion = 0) {
  Bytes bytes;
  put(bytes, session, 4);
  put(bytes, majorVersion, 2);
  put(bytes, minorVersion, 2);
  put(bytes, 0, 4);
  putChecksum(bytes);
  return bytes;
}

struct Header {
  uint8_t type = 0;
  uint8_t coding = 0;
  uint16_t slice = 0;
  uint32_t session = 0;
  uint32_t sequence = 0;
  uint32_t frame = 0;
};

inline Bytes messageBytes(const Header& header, ByteSpan payload) {
  Bytes bytes = {'O', 'C', 'L', 'M', header.type, header.coding};
  put(bytes, header.slice, 2);
  put(bytes, header.session, 4);
  put(bytes, header.sequence, 4);
  put(bytes, header.frame, 4);
  put(bytes, payload.size(), 4);
  put(bytes, checksum(payload), 4);
  putChecksum(bytes);
  append(bytes, payload);
  return bytes;
}

inline Bytes frameBeginPayload(uint32_t base, const std::vector<bool>& slices) {
  Bytes payload;
  put(payload, base, 4);
  put(payload, slices.size(), 2);
  Bytes bits((slices.size() + 7) / 8);
  size_t count = 0;
  for (size_t i = 0; i < slices.size(); ++i) {
    if (slices[i]) {
      bits[i / 8] = static_cast<uint8_t>(bits[i / 8] | 1u << (i % 8));
      ++count;
    }
  }
  put(payload, count, 2);
  append(payload, bits);
  return payload;
}

inline Bytes frameEndPayload(size_t count, const std::vector<uint32_t>& payloadChecksums) {
  Bytes sums;
  for (const uint32_t sum : payloadChecksums) {
    put(sums, sum, 4);
  }
  Bytes payload;
  put(payload, count, 4);
  put(payload, checksum(sums), 4);
  return payload;
}

inline Bytes presentPayload(uint64_t refresh, uint16_t slice, uint16_t flags) {
  Bytes payload;
  put(payload, refresh, 8);
  put(payload, slice, 2);
  put(payload, flags, 2);
  return payload;
}

/// Short runs of zeros do not end a run of others.
inline Bytes runLengthPayload(ByteSpan content) {
  const auto count = [](Bytes& out, size_t value) {
    for (; value >= 128; value >>= 7) {
      out.push_back(static_cast<uint8_t>(128 | (value & 127)));
    }
    out.push_back(static_cast<uint8_t>(value));
  };
  Bytes payload;
  for (size_t at = 0; at < content.size();) {
    size_t zeros = at;
    while (zeros < content.size() && content[zeros] == 0) {
      ++zeros;
    }
    size_t others = zeros;
    while (others < content.size() &&
           (content[others] != 0 || (others + 1 < content.size() && content[others + 1] != 0))) {
      ++others;
    }
    count(payload, zeros - at);
    count(payload, others - zeros);
    append(payload, content.subspan(zeros, others - zeros));
    at = others;
  }
  return payload;
}

/// A zstd frame with its content size in four bytes (RFC 8878, sections 3.1.1.1 and 3.1.1.2), of blocks that are raw or
/// one byte again and again: runs of zeros. For content below 128 KiB.
inline Bytes zstdPayload(ByteSpan content) {
  Bytes payload;
  put(payload, 0xfd2fb528, 4);
  payload.push_back(0xa0);  // size in four bytes, one segment, no checksum
  put(payload, content.size(), 4);
  for (size_t at = 0; at < content.size();) {
    const bool zeros = content[at] == 0;
    size_t end = at;
    while (end < content.size() && (content[end] == 0) == zeros) {
      ++end;
    }
    const size_t last = end == content.size() ? 1 : 0;
    put(payload, last | (zeros ? 2u : 0u) | (end - at) << 3, 3);
    append(payload, content.subspan(at, zeros ? 1 : end - at));
    at = end;
  }
  return payload;
}

inline Bytes difference(ByteSpan a, ByteSpan b) {
  Bytes result(a.begin(), a.end());
  for (size_t i = 0; i < result.size(); ++i) {
    result[i] = static_cast<uint8_t>(result[i] ^ b[i]);
  }
  return result;
}

constexpr uint8_t kArrived = 1;
constexpr uint8_t kShown = 2;
constexpr uint8_t kDropped = 3;
constexpr uint8_t kError = 4;

struct SeenEvent {
  uint8_t type = 0;
  uint8_t flags = 0;
  uint16_t code = 0;  ///< of SHOWN the slice
  uint32_t session = 0;
  uint32_t frame = 0;
  uint64_t time = 0;
  uint32_t refresh = 0;
};

inline std::optional<SeenEvent> eventOf(ByteSpan bytes) {
  if (bytes.size() != 32 || !isWholeRecord(bytes) ||
      std::string_view("OCLE") != std::string_view(reinterpret_cast<const char*>(bytes.data()), 4)) {
    return std::nullopt;
  }
  return SeenEvent{.type = bytes[4],
                   .flags = bytes[5],
                   .code = u16(bytes, 6),
                   .session = u32(bytes, 8),
                   .frame = u32(bytes, 12),
                   .time = u64(bytes, 16),
                   .refresh = u32(bytes, 24)};
}

}  // namespace ocelli::test
