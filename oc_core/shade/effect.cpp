#include "oc_core/shade/effect.h"

#include <algorithm>
#include <string_view>

#include "oc_core/base/check.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

std::string optionValue(const StageInputs& inputs, const std::vector<EffectOption>& options, const char* name) {
  const auto row = std::find_if(options.begin(), options.end(),
                                [&](const EffectOption& option) { return std::string_view(option.name) == name; });
  OC_CHECK(row != options.end(), "an option of the effect");
  const auto given = inputs.options.find(name);
  return given != inputs.options.end() ? given->second : row->initial;
}

std::vector<std::string> camerasWithImages() {
  std::vector<std::string> names;
  for (const CameraName& camera : cameraNames()) {
    if (cameraChoice(camera.name).hasImages()) {
      names.emplace_back(camera.name);
    }
  }
  return names;
}

}  // namespace ocelli
