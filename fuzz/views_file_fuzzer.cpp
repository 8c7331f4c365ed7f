// libFuzzer target: any bytes as views.json. What is read is written, and read again as the same.
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/depth_views/views_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const std::vector<ocelli::ListedView> views = ocelli::viewsFromJsonText(std::string(data, data + size), "fuzz");
    const std::string text = ocelli::viewsJsonText(views);
    for (const ocelli::ListedView& listed : views) {
      if (!(listed.levels.near > 0 && listed.levels.near < listed.levels.far) ||
          listed.colorFile.find('/') != std::string::npos) {
        std::abort();
      }
      for (const uint16_t level : std::initializer_list<uint16_t>{0, 1, 32768, 65535}) {
        const float z = listed.levels.zOf(level);
        if (level > 0 && !(z >= listed.levels.near && z <= listed.levels.far)) {
          std::abort();
        }
      }
    }
    if (ocelli::viewsJsonText(ocelli::viewsFromJsonText(text, "written")) != text) {
      std::abort();
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
