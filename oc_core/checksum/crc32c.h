// CRC-32C (Castagnoli), by ISA-L: the checksums of our own formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ocelli {

/// Of all bytes so far: `before` is that of the bytes that come before these, 0 where there are none.
uint32_t crc32c(std::span<const uint8_t> bytes, uint32_t before = 0);

}  // namespace ocelli
