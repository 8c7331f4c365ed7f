#include "display_sim/viewer/lens_file.h"

#include <fmt/format.h>

#include "oc_core/base/error.h"

namespace ocelli {

std::string lensFileText(const GpcLayout& layout) {
  if (layout.regions.empty()) {
    throw InputError("there is no lens to be saved", "the lens pane", "add one first: click into the picture");
  }
  std::string regions;
  for (const GpcRegion& each : layout.regions) {
    regions += fmt::format(R"({}    {{"center": [{}, {}], "extent": [{}, {}], "zoom": {}, "transition_width": {}}})",
                           regions.empty() ? "" : ",\n", each.center.x, each.center.y, each.extent.x, each.extent.y,
                           each.zoom, each.transitionWidth);
  }
  return fmt::format("{{\n  \"camera\": \"gpc\",\n  \"sampling\": \"{}\",\n  \"regions\": [\n{}\n  ]\n}}\n",
                     layout.sampling->name, regions);
}

}  // namespace ocelli
