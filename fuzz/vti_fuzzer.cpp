// libFuzzer target: any bytes as a VTI file. What is read has all voxels that its grid says, and none beyond.
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/vti_file.h"

namespace {

// More voxels take long, and are made in the same way.
constexpr size_t kMaxVtiVoxels = 1 << 20;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::MemorySource source(std::as_bytes(std::span(data, size)), "fuzz");
    ocelli::VtiHeader header = ocelli::parseVti(source);
    const ocelli::VolumeRecord& record = header.record;
    if (record.grid.voxelCount() > kMaxVtiVoxels) {
      return 0;
    }
    ocelli::ScratchOutput scratch("", "", nullptr);
    ocelli::placeVtiVoxels(header, source, "fuzz.vti", scratch);
    const bool isMapped = !record.file.empty();
    if (record.begins.size() != 1 ||
        (isMapped ? record.begins.front() + record.volumeBytes() > size : scratch.size() != record.volumeBytes())) {
      std::abort();
    }
  } catch (const ocelli::Error&) {
    // Any other exception is a finding.
  }
  return 0;
}
