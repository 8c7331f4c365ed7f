// libFuzzer target: any bytes as a KV6 model. What is read is written again as what it was.
#include <cstdlib>

#include "display_sim/exports/kv6_file.h"
#include "oc_core/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const ocelli::Kv6Model model = ocelli::kv6FromBytes(bytes, "fuzz");
    const std::string written = ocelli::kv6Bytes(model);
    if (written.size() > size || ocelli::kv6FromBytes(written, "fuzz") != model) {
      std::abort();
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
