// libFuzzer target: any bytes as a `.svol`, as they are and once more with checksums that fit.
#include <sstream>
#include <string>

#include "display_sim/svol_file.h"
#include "oc_core/base/error.h"
#include "tests/display_sim/svol_repair.h"

namespace {

void read(const std::vector<uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  try {
    ocelli::SvolReader reader(in, "fuzz");
    std::vector<uint8_t> planes(reader.layout().sliceBytes);
    while (!reader.atEnd()) {
      reader.readSlice(planes);
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
