// libFuzzer target: any bytes as a packed scene, as they are and once more with checksums that fit: all that a reader
// may ask of one.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/pack/pack_summary.h"
#include "oc_core/worlds/packed_source.h"
#include "tests/pack/opack_repair.h"

namespace {

/// A file without a name, which is mapped as any other.
class FileInMemory {
 public:
  FileInMemory() : file_(memfd_create("fuzz", MFD_CLOEXEC)) {}
  ~FileInMemory() { close(file_); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;

  void hold(const std::vector<uint8_t>& bytes) const {
    if (ftruncate(file_, 0) != 0 ||
        pwrite(file_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
      std::abort();
    }
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
}

void read(const std::vector<uint8_t>& bytes) {
  static const FileInMemory file;
  file.hold(bytes);
  attempt([] {
    const ocelli::PackedScene scene = ocelli::openPacked(file.path(), {});
    attempt([&] { ocelli::summaryOf(scene); });
    attempt([&] { scene.verify(); });
    // What is asked for first is checked first: once from the top, as drawing does.
    const ocelli::PackedScene fresh(file.path());
    attempt([&] { ocelli::meshOf(fresh, ocelli::coarsestClusters(fresh, 0.1f)); });
    attempt([&] { ocelli::unpackedMesh(fresh); });
    for (uint32_t group = 0; group < fresh.groupCount(); ++group) {
      fresh.willNeed(group);
    }
    fresh.release();
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(data, data + size);
  read(bytes);
  ocelli::test::repairOpackChecksums(bytes);
  read(bytes);
  return 0;
}
