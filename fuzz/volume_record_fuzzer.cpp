// libFuzzer target: any bytes as what `ocelli-read-volume` hands back. What is read is written as the same bytes again.
#include <algorithm>
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_record.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const auto bytes = std::as_bytes(std::span(data, size));
    const ocelli::VolumeRecord record = ocelli::volumeFromRecord(bytes, "fuzz");
    std::vector<std::byte> again;
    ocelli::writeVolumeRecord(
        record, [&](std::span<const std::byte> part) { again.insert(again.end(), part.begin(), part.end()); });
    if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) {
      std::abort();
    }
    // Does not overflow, and is what a file is asked for.
    if (record.volumeBytes() == 0 || record.begins.back() + record.volumeBytes() < record.volumeBytes()) {
      std::abort();
    }
  } catch (const ocelli::Error&) {
    // Any other exception is a finding.
  }
  return 0;
}
