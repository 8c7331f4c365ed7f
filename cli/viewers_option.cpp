#include "cli/viewers_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/scene_options.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/viewers.h"
#include "oc_core/ray_map/ray_map_file.h"

namespace ocelli {

void addViewersOptions(CLI::App& command, ViewersChoice& choice) {
  command
      .add_option("--viewers", choice.count,
                  "For so many viewers around the display, in equal steps from the reference view on")
      ->check(CLI::Range(1, kMaxViewers))
      ->type_name("N");
  command
      .add_option("--view", choice.views,
                  "Reference view; by default from (0, 0, 10) to the origin. Again for each of several viewers")
      ->allow_extra_args(false)
      ->type_name("FILE.json");
}

std::vector<View> viewsOf(const ViewersChoice& choice) {
  if (choice.views.size() > kMaxViewers) {
    throw InputError(fmt::format("{} views are too many", choice.views.size()), "--view",
                     fmt::format("give at most {}", kMaxViewers));
  }
  if (choice.views.size() > 1) {
    if (choice.count > 0) {
      throw InputError("several views say already where the viewers are", "--viewers",
                       "leave it out, or give one --view to start from");
    }
    std::vector<View> views;
    for (const std::string& file : choice.views) {
      views.push_back(readViewOption(file));
    }
    return views;
  }
  const View first = readViewOption(choice.views.empty() ? "" : choice.views.front());
  return viewsAround(first, std::max(choice.count, 1));
}

std::vector<View> viewsFor(const std::string& camera, const ViewersChoice& choice) {
  if (!namesRayMap(camera)) {
    return viewsOf(choice);
  }
  if (choice.views.size() > 1 || choice.count > 1) {
    throw InputError("a ray map is the camera of one viewer", "--camera " + camera, "leave out --viewers");
  }
  return {cameraView(camera, choice.views.empty() ? "" : choice.views.front())};
}

}  // namespace ocelli
