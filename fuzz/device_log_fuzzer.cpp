// libFuzzer target: any bytes as a device log, as they are and once more with checksums that fit.
#include <sstream>
#include <string>

#include "display_driver/pacing/device_log_reader.h"
#include "oc_core/base/error.h"
#include "tests/display_driver_pacing/device_log_repair.h"

namespace {

// Larger volumes take long to decode, and are decoded in the same way.
constexpr size_t kMaxBytes = size_t{1} << 20;

void read(const std::vector<uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  try {
    ocelli::DeviceLogReader reader(in, "fuzz", kMaxBytes);
    while (reader.next()) {
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(data, data + size);
  read(bytes);
  ocelli::test::repairDeviceLogChecksums(bytes);
  read(bytes);
  return 0;
}
