// libFuzzer target: any bytes as a `.svol`, as they are and once more with checksums that fit.
#include <sstream>
#include <string>

#include "display_sim/frames/svol_summary.h"
#include "oc_core/base/error.h"
#include "tests/display_sim_frames/svol_repair.h"

namespace {

constexpr size_t kMaxBytes = size_t{1} << 24;

void read(const std::vector<uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  try {
    ocelli::SvolReader reader(in, "fuzz");
    if (!reader.frames().empty()) {
      std::vector<uint8_t> planes(reader.layout().sliceBytes);
      reader.readSlice(reader.frames().size() - 1, 0, planes);
    }
    // Larger volumes take long to decode, and are decoded in the same way.
    if (reader.profile().volumeBytes() <= kMaxBytes) {
      ocelli::verifySvol(reader);
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(data, data + size);
  read(bytes);
  ocelli::test::repairSvolChecksums(bytes);
  read(bytes);
  return 0;
}
