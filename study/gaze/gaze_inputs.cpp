#include <algorithm>

#include "oc_core/base/error.h"
#include "study/gaze/gaze_input.h"

namespace ocelli {
namespace {

constexpr std::string_view kShares = ",norm";

}  // namespace

GazeInputKind udpGaze();
GazeInputKind fileGaze();

const std::vector<GazeInputKind>& gazeInputKinds() {
  static const std::vector<GazeInputKind> kinds{udpGaze(), fileGaze()};
  return kinds;
}

std::string gazeInputForms() {
  std::string forms;
  for (const GazeInputKind& kind : gazeInputKinds()) {
    forms += (forms.empty() ? "" : ", ") + kind.form;
  }
  return forms;
}

GazeUnit gazeUnitOf(const std::string& text) {
  return text.ends_with(kShares) ? GazeUnit::kShares : GazeUnit::kPixels;
}

std::unique_ptr<GazeBytes> openGazeBytes(const std::string& text) {
  const size_t colon = text.find(':');
  const auto& kinds = gazeInputKinds();
  const auto kind = std::ranges::find(kinds, text.substr(0, colon), &GazeInputKind::name);
  if (colon == std::string::npos || kind == kinds.end()) {
    throw InputError("this is no input for gaze", "--gaze " + text, "give one of: " + gazeInputForms());
  }
  const size_t end = text.ends_with(kShares) ? text.size() - kShares.size() : text.size();
  return kind->open(text.substr(colon + 1, std::max(end, colon + 1) - colon - 1));
}

}  // namespace ocelli
