#include "oc_core/checksum/crc32c.h"

#include <isa-l/crc.h>

#include <algorithm>

namespace ocelli {

uint32_t crc32c(std::span<const uint8_t> bytes, uint32_t before) {
  constexpr size_t kMost = size_t{1} << 30;  // ISA-L counts with int
  uint32_t crc = ~before;
  while (!bytes.empty()) {
    const auto some = bytes.first(std::min(bytes.size(), kMost));
    // It only reads, though its parameter is not const.
    crc = crc32_iscsi(const_cast<uint8_t*>(some.data()), static_cast<int>(some.size()), crc);
    bytes = bytes.subspan(some.size());
  }
  return ~crc;
}

}  // namespace ocelli
