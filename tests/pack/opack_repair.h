// Makes the checksums of an `.opack` right again after its bytes were changed, so that what lies behind them is tested
// too.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "oc_core/pack/pack_format.h"

namespace ocelli::test {

template <class Record>
Record opackRecord(const std::vector<uint8_t>& file, uint64_t at) {
  Record record;
  std::memcpy(&record, file.data() + at, sizeof(record));
  return record;
}
template <class Record>
void putOpackRecord(std::vector<uint8_t>& file, uint64_t at, const Record& record) {
  std::memcpy(file.data() + at, &record, sizeof(record));
}
inline opack::Trailer opackTrailer(const std::vector<uint8_t>& file) {
  return opackRecord<opack::Trailer>(file, file.size() - sizeof(opack::Trailer));
}

/// Follows offsets and counts as they stand, as far as they stay within the file; the size in the trailer becomes the
/// file's.
inline void repairOpackChecksums(std::vector<uint8_t>& file) {
  if (file.size() < sizeof(opack::Mark) + sizeof(opack::Trailer)) {
    return;
  }
  const auto fits = [&](uint64_t begin, uint64_t size) { return begin <= file.size() && size <= file.size() - begin; };
  opack::Trailer trailer = opackTrailer(file);
  trailer.fileBytes = file.size();
  for (uint64_t i = 0; i < trailer.groups; ++i) {
    const uint64_t at = trailer.tableOffset + i * sizeof(opack::GroupRecord);
    if (!fits(trailer.tableOffset, (i + 1) * sizeof(opack::GroupRecord))) {
      break;
    }
    auto group = opackRecord<opack::GroupRecord>(file, at);
    if (fits(group.offset, group.blobBytes)) {
      group.blobCheck = opack::checksum({file.data() + group.offset, group.blobBytes});
    }
    group.check = opack::checkOf(group);
    putOpackRecord(file, at, group);
  }
  if (fits(trailer.descriptionOffset, trailer.descriptionBytes)) {
    trailer.descriptionCheck = opack::checksum({file.data() + trailer.descriptionOffset, trailer.descriptionBytes});
  }
  trailer.check = opack::checkOf(trailer);
  putOpackRecord(file, file.size() - sizeof(opack::Trailer), trailer);
}

}  // namespace ocelli::test
