#include "cli/depth_views_option.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "oc_core/base/error.h"
#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/depth_views/views_surface.h"

namespace ocelli {
namespace {

/// Of the options of such commands, what has nothing to do with how a scene is read.
constexpr const char* kSceneOptions[] = {"--no-fit",     "--shading", "--no-textures",  "--texture-triangles",
                                         "--point-size", "--labels",  "--label-facing", "--iso",
                                         "--transfer",   "--series",  "--time",         "--animation",
                                         "--rate",       "--between", "--opacity",      "--clip"};

std::string millions(size_t number) {
  return number < 100'000 ? fmt::format("{}", number) : fmt::format("{:.1f} M", static_cast<double>(number) / 1e6);
}

}  // namespace

void addFromOption(CLI::App& command, std::string& folder, const std::string& help) {
  command.add_option("--from", folder, help)->type_name("FOLDER");
}

void requireSceneOrViews(const CLI::App& command, const std::string& scene, const std::string& folder) {
  if (scene.empty() && folder.empty()) {
    throw InputError("there is nothing to build of", "SCENE", "give a SCENE, or --from FOLDER of views with depth");
  }
  if (folder.empty()) {
    return;
  }
  if (!scene.empty()) {
    throw InputError("there is a SCENE (" + scene + ") and a folder of views", "--from " + folder, "give one of them");
  }
  for (const char* name : kSceneOptions) {
    const CLI::Option* option = command.get_option_no_throw(name);
    if (option != nullptr && option->count() > 0) {
      throw InputError(std::string(name) + " says how a scene is read, and views with depth are taken as they are",
                       "--from " + folder, std::string("leave out ") + name);
    }
  }
}

Mesh surfaceFrom(const std::string& folder, const CommandContext& context) {
  std::vector<DepthView> views = readDepthViews(folder, context.progress());
  const size_t count = views.size();
  ViewsSurface surface = surfaceOfViews(std::move(views), {}, context.progress());
  context.note(fmt::format("{} {}, {} samples, {} of them kept, {} triangles", count, count == 1 ? "view" : "views",
                           millions(surface.samples), millions(surface.keptSamples()),
                           millions(surface.mesh.triangles.size())));
  return std::move(surface.mesh);
}

}  // namespace ocelli
