// Numbers of the `.svol` format that its writer, its reader and their tests share (docs/svol.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ocelli::svol {

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'S', 'V', 'O', 'L', '\r', '\n', 0x1a};
inline constexpr uint32_t kVersion = 1;
inline constexpr size_t kHeaderBytes = 32;  ///< before the profile's JSON text
inline constexpr size_t kMostProfileBytes = 1 << 16;
inline constexpr size_t kRecordHeaderBytes = 8;
inline constexpr size_t kChecksumBytes = 4;

inline void store32(uint8_t* at, uint32_t value) {
  for (int i = 0; i < 4; ++i) {
    at[i] = static_cast<uint8_t>(value >> (8 * i));
  }
}

inline uint32_t load32(const uint8_t* at) {
  return at[0] | static_cast<uint32_t>(at[1]) << 8 | static_cast<uint32_t>(at[2]) << 16 |
         static_cast<uint32_t>(at[3]) << 24;
}

/// CRC-32 of ISO 3309 (that of zlib and PNG). `before` is the checksum of what came before these bytes.
uint32_t checksum(std::span<const uint8_t> bytes, uint32_t before = 0);

}  // namespace ocelli::svol
