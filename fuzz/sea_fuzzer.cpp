// libFuzzer target: any bytes as a sea of images, as they are and once more with checksums that fit: all that a reader
// may ask of one.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/sea/sea_file.h"
#include "oc_core/sea/sea_summary.h"
#include "tests/sea/sea_repair.h"

namespace {

template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
}

void read(const std::vector<uint8_t>& bytes) {
  static const int file = memfd_create("fuzz", MFD_CLOEXEC);
  if (ftruncate(file, 0) != 0 || pwrite(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    std::abort();
  }
  attempt([] {
    const ocelli::SeaFile sea("/proc/self/fd/" + std::to_string(file));
    attempt([&] { ocelli::summaryOf(sea); });
    attempt([&] { sea.verify(false); });
    const ocelli::SeaProjection& projection = sea.settings().projection;
    constexpr int kMaxPixels = 1 << 12;  // others take their time, and nothing more
    for (uint32_t i = 0; i < sea.count() && i < 8 && projection.width * projection.height <= kMaxPixels; ++i) {
      attempt([&] { sea.image(i); });
      attempt([&] { sea.view(sea.pose(i)); });
    }
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(data, data + size);
  read(bytes);
  ocelli::test::repairSeaChecksums(bytes);
  read(bytes);
  return 0;
}
