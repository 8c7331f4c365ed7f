#include "display_sim/solidity/eye_groups.h"

namespace ocelli {

std::vector<EyeGroup> eyesOfCell(const View& reference, const ViewCell& cell, int interiorViews, unsigned seed) {
  std::vector<EyeGroup> groups;
  const auto add = [&](const std::string& name, const std::vector<View>& views) {
    if (!views.empty()) {
      groups.push_back({name, {}});
    }
    for (const View& view : views) {
      groups.back().eyes.push_back(view.eye);
    }
  };
  add("reference", {reference});
  add("edges", cell.edgeViews(reference));
  add("interior", cell.interiorViews(reference, interiorViews, seed));
  return groups;
}

}  // namespace ocelli
