// libFuzzer target: any bytes as a transfer function. What is read is written, read again, and asked for values.
#include <cmath>
#include <cstdlib>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/volume/transfer_file.h"

namespace {

/// From 0 to 3.
ocelli::ScalarVolume smallVolume() {
  ocelli::VolumeGrid grid;
  grid.size = {4, 1, 1};
  return {grid, {0, 1, 2, 3}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const ocelli::ScalarVolume kVolume = smallVolume();
  try {
    const auto description = ocelli::transferFromJsonText(std::string(data, data + size), "fuzz");
    const auto again = ocelli::transferFromJsonText(ocelli::transferToJsonText(description), "fuzz");
    const auto appearance = ocelli::appearanceOf(again, kVolume, 1);
    for (const double value : {-1e9, 0.0, 1.5, 1e9}) {
      const ocelli::OpticalSample sample = appearance.transfer.at(value);
      if (!std::isfinite(sample.extinction) || !(sample.extinction >= 0)) {
        std::abort();
      }
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
