// Makes the checksums of a `.svol` right again after its bytes were changed, so that what lies behind them is tested
// too.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "display_sim/frames/svol_format.h"

namespace ocelli::test {

/// Follows the sizes as they stand, as far as they stay within the file.
inline void repairSvolChecksums(std::vector<uint8_t>& file) {
  const auto fits = [&](uint64_t begin, uint64_t size) { return begin <= file.size() && size <= file.size() - begin; };
  const auto sum = [&](uint64_t begin, uint64_t size) {
    return svol::checksum({file.data() + begin, static_cast<size_t>(size)});
  };
  // A record of `size` bytes, its checksum among them. Returns where the next one begins.
  const auto repair = [&](uint64_t begin, uint64_t size) {
    svol::store32(file.data() + begin + size - svol::kChecksumBytes, sum(begin, size - svol::kChecksumBytes));
    return begin + size;
  };
  if (!fits(0, svol::kHeaderBytes)) {
    return;
  }
  const uint64_t slices = svol::load32(file.data() + 20);
  const uint64_t headerBytes = svol::kHeaderBytes + uint64_t{svol::load32(file.data() + 12)} +
                               svol::load32(file.data() + 16) + svol::kChecksumBytes;
  if (!fits(0, headerBytes)) {
    return;
  }
  uint64_t at = repair(0, headerBytes);
  const uint64_t headBytes = svol::kFrameFieldBytes + slices * svol::kSliceEntryBytes + svol::kChecksumBytes;
  while (fits(at, headBytes) && svol::load32(file.data() + at) == svol::kFrameMark) {
    uint64_t payload = at + headBytes;
    for (uint64_t i = 0; i < slices; ++i) {
      uint8_t* entry = file.data() + at + svol::kFrameFieldBytes + i * svol::kSliceEntryBytes;
      const uint32_t bytes = svol::load32(entry) >> 2;
      if (fits(payload, bytes) && bytes > 0) {
        svol::store32(entry + 4, sum(payload, bytes));
      }
      payload += bytes;
    }
    at = repair(at, headBytes);
    at += svol::load32(file.data() + at - headBytes + 20);
  }
  if (fits(at, svol::kIndexFieldBytes) && svol::load32(file.data() + at) == svol::kIndexMark) {
    const uint64_t indexBytes = svol::kIndexFieldBytes +
                                uint64_t{svol::load32(file.data() + at + 4)} * svol::kIndexEntryBytes +
                                svol::kChecksumBytes;
    if (fits(at, indexBytes + svol::kEndBytes)) {
      repair(repair(at, indexBytes), svol::kEndBytes);
    }
  }
}

}  // namespace ocelli::test
