// Makes the checksums of a `.svol` right again after its bytes were changed, so that what lies behind them is tested
// too.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "display_sim/svol_format.h"

namespace ocelli::test {

/// Follows the sizes as they stand, as far as they stay within the file.
inline void repairSvolChecksums(std::vector<uint8_t>& file) {
  const auto repair = [&](size_t begin, size_t size) {
    svol::store32(file.data() + begin + size, svol::checksum({file.data() + begin, size}));
  };
  if (file.size() < svol::kHeaderBytes) {
    return;
  }
  size_t at = 0;
  size_t size = svol::kHeaderBytes + svol::load32(file.data() + 12);
  while (size + svol::kChecksumBytes <= file.size() - at) {
    repair(at, size);
    at += size + svol::kChecksumBytes;
    if (file.size() - at < svol::kRecordHeaderBytes) {
      return;
    }
    size = svol::kRecordHeaderBytes + svol::load32(file.data() + at + 4);
  }
}

}  // namespace ocelli::test
