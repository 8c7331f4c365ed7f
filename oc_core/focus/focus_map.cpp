#include "oc_core/focus/focus_map.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"

namespace ocelli {

std::vector<FocusBox> focusPlaces(const GpcLayout& layout, const glm::ivec2& size) {
  std::vector<FocusBox> boxes;
  for (const GpcRegion& region : layout.regions) {
    boxes.push_back({glm::dvec2(region.center) * glm::dvec2(size), glm::dvec2(region.extent) * glm::dvec2(size) / 2.0});
  }
  return boxes;
}

std::vector<FocusBox> focusContents(const GpcLayout& layout, const glm::ivec2& size) {
  std::vector<FocusBox> boxes = focusPlaces(layout, size);
  for (size_t i = 0; i < boxes.size(); ++i) {
    boxes[i].half /= static_cast<double>(layout.regions[i].zoom);
  }
  return boxes;
}

void requireFoci(const GpcLayout& layout, const std::string& where) {
  if (layout.regions.empty()) {
    throw InputError("the camera has no regions, so that nothing is in focus", where, "add one");
  }
  for (size_t i = 0; i < layout.regions.size(); ++i) {
    if (!(layout.regions[i].zoom > 1)) {
      throw InputError(fmt::format("region {} has a zoom of {:g}: it shows no more than the plain view", i + 1,
                                   layout.regions[i].zoom),
                       where, "zoom by more than 1, or leave it out");
    }
  }
}

}  // namespace ocelli
