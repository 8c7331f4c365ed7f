// `ocelli explore`: someone walks through a scene with a constructor of graph and curved ray cameras.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cli/command.h"
#include "cli/explore_window.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "display_sim/observing/frame_sink.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_folder.h"
#include "oc_core/explore/explore_offscreen.h"
#include "oc_core/explore/explore_shown_camera.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {
namespace {

struct ExploreChoice {
  SceneChoice scene;
  std::string script;
  std::string folder = ".";
  std::string view;
  std::optional<double> metre;
  WalkerOptions walker;
  std::string camera;
  bool benchmark = false;
  bool jumps = false;
  std::string changes;
  ExploreWindowChoice window;
};

/// Where the eye of a view file is and looks, level or not.
WalkerView walkerViewOf(const View& view) {
  const glm::dvec3 look = glm::normalize(glm::dvec3(view.target) - glm::dvec3(view.eye));
  return {glm::dvec3(view.eye), headingDegreesOf(look), degreesFromRadians(std::asin(std::clamp(look.y, -1.0, 1.0)))};
}

ExploreRecording recordingOf(const std::filesystem::path& path, int width, int height) {
  const std::shared_ptr<FrameSink> sink = videoFile(path, {width, height, kExploreFramesPerSecond});
  return {[sink](const Image<Rgb8>& frame) { sink->add(frame); }, [sink] { sink->finish(); }};
}

void printReport(const ExploreReport& report, const ExploreChoice& choice, const CommandContext& context) {
  if (choice.benchmark) {
    const ExploreTimes& times = report.times;
    context.print(
        fmt::format("frames      {}\nms a frame  {:.1f} median, {:.1f} of 90 %, {:.1f} of 99 %\n"
                    "frames a second  {:.1f}\nCPU time    {:.1f} ms a frame, all threads together\n",
                    report.frames, times.percentile(0.5), times.percentile(0.9), times.percentile(0.99),
                    1000 / std::max(times.mean(), 1e-9), times.processorMeanMs));
  }
  if (choice.jumps) {
    context.print(fmt::format("jumps       {} of {} frames\n", report.jumps(), report.changes.size()));
    if (report.worst) {
      context.print(fmt::format("worst       frame {}: {:.2f} of 255, the pinhole {:.2f}, a turn {:.2f}\n",
                                report.worst->change.frame, report.worst->change.picture, report.worst->change.pinhole,
                                report.worst->change.turn));
    }
  }
}

/// Of the frame that jumps most, to look at.
void writeJump(const WorstFrame& worst, const std::filesystem::path& folder, const CommandContext& context) {
  makeFolder(folder);
  const auto write = [&](const char* name, const Image<Rgb8>& image) {
    writePng(folder / name, image);
    context.note("wrote " + (folder / name).string());
  };
  write("jump_before.png", worst.before);
  write("jump_after.png", worst.after);
  write("jump_difference.png", worst.difference());
}

std::shared_ptr<ExploreScene> openScene(const ExploreChoice& choice, const Progress& progress) {
  SceneOptions sceneOptions = choice.scene.options;
  sceneOptions.fit = false;
  GuidedScene loaded = loadGuidedScene(choice.scene.source, sceneOptions, progress);
  ExploreSceneOptions options;
  options.metre = choice.metre ? choice.metre : metreOf(choice.scene.source, loaded).units;
  options.findWays = [](const Mesh& mesh, double metre, const Progress& searching) {
    return findWalkMap(mesh, inUnits({}, metre), searching);
  };
  return std::make_shared<ExploreScene>(std::move(loaded), std::move(options));
}

void explore(const ExploreChoice& choice, const CommandContext& context) {
  const bool plays = !choice.script.empty();
  checkExploreWindow(choice.window, plays, choice.jumps || !choice.changes.empty());
  checkSecondOutput(choice.changes, "--changes", "");
  if (namesRayMap(choice.camera)) {
    throw InputError("a ray map is no camera to walk with: its rays stay where its file has them",
                     "--camera " + choice.camera,
                     "draw it with `ocelli render SCENE --camera " + choice.camera +
                         " -o IMAGE.png`, or give a constructor, or the JSON file of a graph or curved ray camera");
  }
  if (choice.benchmark && !plays) {
    throw InputError("a script is needed", "--benchmark",
                     "give --offscreen SCRIPT.json, such as oc_core/explore/examples/town_walk.json");
  }
  ExploreOffscreenOptions offscreen;
  offscreen.explorer.walker = choice.walker;
  offscreen.folder = choice.folder;
  offscreen.measureTimes = choice.benchmark;
  offscreen.measureJumps = choice.jumps || !choice.changes.empty();
  offscreen.record = recordingOf;
  offscreen.wrote = [&](const std::filesystem::path& path) { context.note("wrote " + path.string()); };
  if (!choice.view.empty()) {
    offscreen.start = walkerViewOf(readViewOption(choice.view));
  }
  if (!choice.camera.empty()) {
    checkExploreCamera(choice.camera);
  }
  offscreen.camera = choice.camera;
  const auto read = [&](const Progress& progress) { return openScene(choice, progress); };
  if (!plays) {
    exploreInWindow(choice.window, {choice.scene.source, read, offscreen});
    return;
  }
  const ExploreScript script = readExploreScript(choice.script);
  if (choice.window.window) {
    playScriptInWindow(choice.window, {choice.scene.source, read, offscreen}, script, context);
    return;
  }
  const std::shared_ptr<ExploreScene> scene = read(context.progress());
  const ExploreReport report = exploreOffscreen(*scene, script, std::move(offscreen));
  if (!choice.changes.empty()) {
    writeFile(choice.changes, csvOf(report.changes));
    context.note("wrote " + choice.changes);
  }
  printReport(report, choice, context);
  if (choice.jumps && report.jumps() > 0) {
    writeJump(*report.worst, choice.folder, context);
  }
}

}  // namespace

void addExploreCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "explore", "Walk through a scene with cameras that look around corners and into openings");
  const auto choice = std::make_shared<ExploreChoice>();
  addSceneOptions(command, choice->scene, context);
  std::string cameras;
  for (const LiveConstructorRow& row : liveConstructors()) {
    cameras += fmt::format("\n  {}: {}", row.name, row.description);
  }
  command
      .add_option("--camera", choice->camera,
                  "What to begin with, by default the pinhole; or a camera's file, shown as it is:" + cameras)
      ->type_name("NAME|FILE.json");
  addViewOption(command, choice->view);
  addMetreOption(command, choice->metre);
  command.add_option("--eye-height", choice->walker.eyeHeight, "Metres over the floor")
      ->check(numberCheck(0.1, 100))
      ->capture_default_str()
      ->type_name("METRES");
  command.add_option("--speed", choice->walker.speed, "Metres a second")
      ->check(numberCheck(0.01, 1000))
      ->capture_default_str()
      ->type_name("METRES");
  command.add_option("--fov", choice->walker.fovHorizontal, "Degrees that the image is wide")
      ->check(numberCheck(20, 120))
      ->capture_default_str()
      ->type_name("DEGREES");
  command.add_option("--offscreen", choice->script, "Play a script, without a display")->type_name("SCRIPT.json");
  addExploreWindowOptions(command, choice->window);
  command.add_option("-o,--output", choice->folder, "Folder for images, cameras and videos")->type_name("DIR");
  command.add_flag("--benchmark", choice->benchmark, "Draw every frame of the script, and print how long frames take");
  command.add_flag(
      "--jumps", choice->jumps,
      "Print how many frames of the script change more than the pinhole's do, and save that which does most");
  command
      .add_option("--changes", choice->changes,
                  "A table of how much each frame of the script changes, and the pinhole's")
      ->type_name("FILE.csv");
  context.finish(command,
                 "  ocelli explore builtin:town\n"
                 "  ocelli explore house.glb --camera portal\n"
                 "  ocelli explore builtin:town --offscreen oc_core/explore/examples/town_walk.json -o frames\n"
                 "  ocelli explore builtin:maze --camera portal --offscreen walk.json --jumps",
                 [choice, context] { explore(*choice, context); });
}

}  // namespace ocelli
