// libFuzzer target: any bytes as a MetaImage. Where its voxels follow the header, what is read has all that its grid
// says, and none beyond.
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/volume/import/meta_image_file.h"

namespace {

// More voxels take long, and are made in the same way.
constexpr size_t kMaxMetaImageVoxels = 1 << 20;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::MemorySource source(std::as_bytes(std::span(data, size)), "fuzz");
    ocelli::MetaImageHeader header = ocelli::parseMetaImage(source);
    ocelli::VolumeRecord& record = header.record;
    if (!header.files.empty() || header.isOffsetFromEnd ||
        header.volumes * record.grid.voxelCount() > kMaxMetaImageVoxels) {
      return 0;
    }
    ocelli::ScratchOutput scratch("", "", nullptr);
    ocelli::placeVoxels(record, header.volumes, header.voxels, source, "fuzz.mha", scratch);
    const bool isMapped = !record.file.empty();
    if (record.begins.size() != header.volumes ||
        (isMapped ? record.begins.back() + record.volumeBytes() > size
                  : scratch.size() != header.volumes * record.volumeBytes())) {
      std::abort();
    }
  } catch (const ocelli::Error&) {
    // Any other exception is a finding.
  }
  return 0;
}
