// Makes the checksums of a `.sea` right again after its bytes were changed, so that what lies behind them is tested
// too.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "oc_core/sea/sea_format.h"

namespace ocelli::test {

template <class Record>
Record seaRecord(const std::vector<uint8_t>& file, uint64_t at) {
  Record record;
  std::memcpy(&record, file.data() + at, sizeof(record));
  return record;
}
template <class Record>
void putSeaRecord(std::vector<uint8_t>& file, uint64_t at, const Record& record) {
  std::memcpy(file.data() + at, &record, sizeof(record));
}

/// Follows sizes and offsets as they stand, as far as they stay within the file; the size in the header becomes the
/// file's.
inline void repairSeaChecksums(std::vector<uint8_t>& file) {
  const auto fits = [&](uint64_t begin, uint64_t size) { return begin <= file.size() && size <= file.size() - begin; };
  if (!fits(0, sizeof(sea::Header))) {
    return;
  }
  auto header = seaRecord<sea::Header>(file, 0);
  header.fileBytes = file.size();
  putSeaRecord(file, 0, sea::sealed(header));
  for (uint64_t i = 0; fits(header.posesOffset, (i + 1) * sizeof(sea::PoseEntry)) && i < header.images; ++i) {
    const uint64_t at = header.posesOffset + i * sizeof(sea::PoseEntry);
    putSeaRecord(file, at, sea::sealed(seaRecord<sea::PoseEntry>(file, at)));
  }
  for (uint64_t i = 0; fits(header.indexOffset, (i + 1) * sizeof(sea::IndexEntry)) && i < header.images; ++i) {
    const uint64_t at = header.indexOffset + i * sizeof(sea::IndexEntry);
    auto entry = seaRecord<sea::IndexEntry>(file, at);
    if (fits(entry.offset, entry.payloadBytes)) {
      entry.payloadCheck = crc32c({file.data() + entry.offset, entry.payloadBytes});
    }
    putSeaRecord(file, at, sea::sealed(entry));
  }
  for (uint64_t at = sizeof(header); fits(at, sizeof(sea::RecordHeader));) {
    auto record = seaRecord<sea::RecordHeader>(file, at);
    const uint64_t payload = at + sizeof(record);
    if (!fits(payload, record.payloadBytes)) {
      break;
    }
    record.payloadCheck = crc32c({file.data() + payload, record.payloadBytes});
    putSeaRecord(file, at, sea::sealed(record));
    at = payload + sea::paddedBytes(record.payloadBytes);
  }
}

}  // namespace ocelli::test
