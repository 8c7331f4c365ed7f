#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"
#include "study/markers/marker_output.h"

namespace ocelli {

MarkerOutputKind udpOutput();
MarkerOutputKind serialOutput();
MarkerOutputKind fileOutput();

const std::vector<MarkerOutputKind>& markerOutputKinds() {
  static const std::vector<MarkerOutputKind> kinds{udpOutput(), serialOutput(), fileOutput()};
  return kinds;
}

std::string markerOutputForms() {
  std::string forms;
  for (const MarkerOutputKind& kind : markerOutputKinds()) {
    forms += (forms.empty() ? "" : ", ") + kind.form;
  }
  return forms;
}

std::unique_ptr<MarkerOutput> openMarkerOutput(const std::string& text) {
  const size_t colon = text.find(':');
  const auto& kinds = markerOutputKinds();
  const auto kind = std::ranges::find(kinds, text.substr(0, colon), &MarkerOutputKind::name);
  if (colon == std::string::npos || kind == kinds.end()) {
    throw InputError("this is no output for markers", fmt::format("--markers {}", text),
                     "give one of: " + markerOutputForms());
  }
  return kind->open(text.substr(colon + 1));
}

}  // namespace ocelli
