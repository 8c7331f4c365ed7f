// libFuzzer target: any bytes as what `ocelli-read-volume` hands back. What is read, whose texts are made printable
// then, is written as bytes that are read as the same.
#include <cstdlib>
#include <span>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_record.h"

namespace {

std::vector<std::byte> bytesOf(const ocelli::VolumeRecord& record) {
  std::vector<std::byte> bytes;
  ocelli::writeVolumeRecord(
      record, [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const auto bytes = std::as_bytes(std::span(data, size));
    const ocelli::VolumeRecord record = ocelli::volumeFromRecord(bytes, "fuzz");
    const std::vector<std::byte> again = bytesOf(record);
    if (bytesOf(ocelli::volumeFromRecord(again, "fuzz")) != again) {
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
