// libFuzzer target: any bytes as a setup of feeds, and as a table of known places. What is read is written again as it
// was read; of what is no graph camera that is said.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds/known_places.h"

namespace {

/// Calls `work`. Any exception but an InputError is a finding.
template <class Work>
void attempt(const Work& work) {
  try {
    work();
  } catch (const ocelli::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(data, data + size);
  attempt([&] {
    const ocelli::FeedSetup setup = ocelli::feedSetupFromJsonText(text, "fuzz");
    if (!(ocelli::feedSetupFromJsonText(ocelli::jsonText(setup), "fuzz") == setup)) {
      std::abort();
    }
    const ocelli::FeedGraph graph(setup);
    for (size_t i = 0; i < graph.frusta(); ++i) {
      static_cast<void>(graph.feedPixelAt(i, {setup.output.width / 2.0, setup.output.height / 2.0}));
    }
  });
  attempt([&] { static_cast<void>(ocelli::knownPlacesFromJsonText(text, "fuzz")); });
  return 0;
}
