#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/feeds_demo.h"
#include "cli/values.h"
#include "display_driver/demo/demo_page.h"
#include "display_driver/demo/portal_demo.h"
#include "display_driver/demo/volume_demo.h"
#include "display_driver/demo/walk_demo.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/evaluation/evaluation_table.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

struct DemoChoice {
  std::string output = "demo";
  std::vector<std::string> scenes;
  bool only = false;
  std::string size = "720x480";
  std::string profile = "perspecta";
};

struct TitledScene {
  std::string title;
  std::string source;
  std::string name;  // of its folder
  bool isWalk = false;
  std::optional<PortalDemoView> portals = {};  // of one that knows its portals: from where
};

const std::vector<TitledScene> kBuiltinScenes{
    {"A teapot in a room", "builtin:room", "room"},
    {"Four statues", "builtin:statues", "statues"},
    {"A fence before a wall", "builtin:fence", "fence"},
    {"Behind a double door", "builtin:doors", "doors"},
    {"A maze to walk in", "builtin:maze", "maze", true},
    {"A house to walk in", "builtin:house", "house", false,
     PortalDemoView{{-4.8f, 1.6f, -0.4f},
                    {-7.4f, 1.5f, 0.85f},
                    "a corridor",
                    "A chair and a window through the door.",
                    "The kitchen: a table and a counter, too."}},
    {"A city to walk in", "builtin:city", "city", false,
     PortalDemoView{{9, 1.7f, 40},
                    {4, 2.2f, 30},
                    "a crossing",
                    "The street to the left is hidden by the house at its corner.",
                    "The street to the left, to its end."}},
    {"A head, as a CT sees it", "builtin:volume,name=skull,size=192", "skull"},
};

// A mesh file is put into a room, so that there is something that it can hide.
TitledScene sceneOf(const std::string& argument, size_t index) {
  const std::string name = fmt::format("given-{}", index);
  if (isBuiltinScene(argument) || isVolumeSource(argument)) {
    return {argument, argument, name};
  }
  if (argument.find(',') != std::string::npos) {
    throw InputError("the demo cannot take a path with a comma", argument,
                     "rename the file, or give it through a link");
  }
  return {std::filesystem::path(argument).filename().string() + " in a room", "builtin:room,mesh=" + argument, name};
}

void runDemo(const DemoChoice& choice, const CommandContext& context) {
  DemoOptions options;
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  options.profile = loadProfile(choice.profile);
  // The given ones first: a wrong path shows at once.
  std::vector<TitledScene> wanted;
  for (const std::string& argument : choice.scenes) {
    wanted.push_back(sceneOf(argument, wanted.size() + 1));
  }
  if (!choice.only) {
    wanted.insert(wanted.end(), kBuiltinScenes.begin(), kBuiltinScenes.end());
  }
  if (wanted.empty()) {
    throw InputError("no scene is given", "--only", "ocelli demo --only bunny.obj");
  }
  std::vector<DemoScene> scenes;
  for (const TitledScene& each : wanted) {
    context.note(fmt::format("{} ({})", each.title, each.source));
    if (isVolumeSource(each.source)) {
      scenes.push_back(runVolumeDemo(each.title, each.source, choice.output, each.name, options, context.progress()));
      continue;
    }
    if (each.portals) {
      scenes.push_back(
          runPortalDemo(each.title, each.source, *each.portals, choice.output, each.name, options, context.progress()));
      continue;
    }
    if (each.isWalk) {
      scenes.push_back(runWalkDemo(each.title, each.source, choice.output, each.name, options, context.progress()));
      continue;
    }
    scenes.push_back(runDemoScene(each.title, each.source, choice.output, each.name, options, context.progress()));
    context.print(each.title + "\n" + evaluationTable(scenes.back().figures) + "\n");
  }
  if (!choice.only) {
    context.note("Graph cameras from video (builtin:corridor_t)");
    if (auto feeds = runFeedsDemo(choice.output, context)) {
      scenes.push_back(std::move(*feeds));
    }
  }
  const std::filesystem::path page = std::filesystem::path(choice.output) / "index.html";
  writeFile(page, demoPage(scenes, options, OCELLI_VERSION));
  context.note("wrote " + page.string());
}

}  // namespace

void addDemoCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command =
      *program.add_subcommand("demo", "Run the whole way from scene to display, and leave a page that shows it");
  const auto choice = std::make_shared<DemoChoice>();
  command.add_option("SCENE", choice->scenes,
                     "More scenes: mesh files, put into a room, volumes, or builtin:NAME[,key=value...]");
  command.add_option("-o,--output", choice->output, "Folder for index.html and its images")->type_name("DIR");
  command.add_flag("--only", choice->only, "Show the given scenes alone, without those that come with it");
  command.add_option("--size", choice->size, "Of the reference images")->type_name("WIDTHxHEIGHT");
  command.add_option("--profile", choice->profile, "Display to slice for")->type_name("NAME|FILE.json");
  context.finish(command,
                 "  ocelli demo\n"
                 "  ocelli demo -o page bunny.obj\n"
                 "  ocelli demo --only --profile perspecta-99 builtin:boxes,seed=3",
                 [choice, context] { runDemo(*choice, context); });
}

}  // namespace ocelli
