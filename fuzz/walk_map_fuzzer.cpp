// libFuzzer target: any bytes as a file of a walk map. What is read is written again as it was read.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/walkable/walk_map_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::WalkMap map = ocelli::walkMapFromJsonText(std::string(data, data + size), "fuzz");
    const std::string text = ocelli::jsonText(map);
    const ocelli::WalkMap again = ocelli::walkMapFromJsonText(text, "fuzz");
    if (again.cells != map.cells || again.partOfCell != map.partOfCell || ocelli::jsonText(again) != text) {
      std::abort();
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
