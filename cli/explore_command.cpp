// `ocelli explore`: someone walks through a scene with a constructor of graph and curved ray cameras.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cli/command.h"
#include "cli/gl_drawing.h"
#include "cli/number_check.h"
#include "cli/scene_options.h"
#include "display_sim/observing/frame_sink.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/explore/explore_offscreen.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/explore_window/explore_window_run.h"
#include "oc_core/explore_window/explore_window_session.h"
#include "oc_core/gl/gl_context.h"
#endif

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
  bool window = false;
  double scale = 1;
  std::string gl = "auto";
  std::string video;
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
                    "frames a second  {:.1f}\n",
                    report.frames, times.percentile(0.5), times.percentile(0.9), times.percentile(0.99),
                    1000 / std::max(times.mean(), 1e-9)));
  }
  if (choice.jumps) {
    context.print(fmt::format("jumps       {} of {} frames\n", report.jumps(), report.changes.size()));
    if (report.worst) {
      context.print(fmt::format("worst       frame {}: {:.2f} of 255, the pinhole {:.2f}, a turn {:.2f}\n",
                                report.worst->frame, report.worst->picture, report.worst->pinhole, report.worst->turn));
    }
  }
}

GuidedScene sceneOf(const ExploreChoice& choice, const Progress& progress) {
  SceneOptions options = choice.scene.options;
  options.fit = false;
  return loadGuidedScene(choice.scene.source, options, progress);
}

ExploreSceneOptions exploreSceneOptions(const ExploreChoice& choice) {
  ExploreSceneOptions options;
  options.metre = choice.metre;
  return options;
}

#ifdef OCELLI_WITH_OPENGL
double percentileOf(const std::vector<double>& milliseconds, double share) {
  return ExploreTimes{milliseconds, std::vector<double>(milliseconds.size())}.percentile(share);
}

ExplorerWindowOptions windowModelOf(const ExploreChoice& choice) {
  ExplorerWindowOptions options;
  options.read = [choice](const Progress& progress) { return sceneOf(choice, progress); };
  options.scene = exploreSceneOptions(choice);
  options.explorer.walker = choice.walker;
  if (!choice.view.empty()) {
    options.start = walkerViewOf(readViewOption(choice.view));
  }
  options.camera = choice.camera;
  return options;
}

void exploreInWindow(const ExploreChoice& choice, const CommandContext& context) {
  ExploreWindowRunOptions options;
  options.title = "Ocelli: " + choice.scene.source;
  options.model = windowModelOf(choice);
  options.folder = choice.folder;
  options.record = recordingOf;
  if (!choice.video.empty()) {
    options.video = choice.video;
  }
  options.wrote = [&](const std::filesystem::path& path) { context.note("wrote " + path.string()); };
  runExploreWindow(options);
}

void playInWindow(const ExploreChoice& choice, const CommandContext& context) {
  const ExploreScript script = readExploreScript(choice.script);
  const std::unique_ptr<GlContext> gl = openGlContext(choice.gl, "--gl");
  ExploreWindowSessionOptions options;
  options.model = windowModelOf(choice);
  options.folder = choice.folder;
  options.contentScale = choice.scale;
  options.record = recordingOf;
  options.wrote = [&](const std::filesystem::path& path) { context.note("wrote " + path.string()); };
  const ExploreWindowTimes times = playInExploreWindow(*gl, script, std::move(options));
  if (choice.benchmark) {
    context.print(
        fmt::format("frames            {}\nwalk and images   {:.1f} ms median, {:.1f} of 90 %\n"
                    "window            {:.1f} ms median, {:.1f} of 90 %\n",
                    times.walk.size(), percentileOf(times.walk, 0.5), percentileOf(times.walk, 0.9),
                    percentileOf(times.window, 0.5), percentileOf(times.window, 0.9)));
  }
}
#else
void exploreInWindow(const ExploreChoice&, const CommandContext&) {
  failWithoutOpenGl("explore without --offscreen");
}
void playInWindow(const ExploreChoice&, const CommandContext&) {
  failWithoutOpenGl("--window");
}
#endif

/// Options that say nothing without others.
void checkTogether(const ExploreChoice& choice) {
  const auto require = [](bool given, bool holds, const std::string& option, const std::string& next) {
    if (given && !holds) {
      throw InputError("it means nothing here", option, next);
    }
  };
  const bool plays = !choice.script.empty();
  require(choice.window, plays, "--window", "give --offscreen SCRIPT.json; without it there is a window anyhow");
  require(choice.gl != "auto" || choice.scale != 1, choice.window, "--gl, --scale", "give --window with --offscreen");
  require(choice.benchmark, plays, "--benchmark", "give --offscreen SCRIPT.json");
  require(choice.jumps, plays && !choice.window, "--jumps", "give --offscreen SCRIPT.json, without --window");
  require(!choice.video.empty(), !plays, "--record", "a script has the step {\"record\": \"walk.mp4\"}");
}

void explore(const ExploreChoice& choice, const CommandContext& context) {
  checkTogether(choice);
  if (choice.script.empty()) {
    exploreInWindow(choice, context);
    return;
  }
  if (choice.window) {
    playInWindow(choice, context);
    return;
  }
  const ExploreScript script = readExploreScript(choice.script);
  ExploreScene scene(sceneOf(choice, context.progress()), exploreSceneOptions(choice));
  ExploreOffscreenOptions offscreen;
  offscreen.explorer.walker = choice.walker;
  offscreen.folder = choice.folder;
  offscreen.measureTimes = choice.benchmark;
  offscreen.measureJumps = choice.jumps;
  offscreen.record = recordingOf;
  offscreen.wrote = [&](const std::filesystem::path& path) { context.note("wrote " + path.string()); };
  if (!choice.view.empty()) {
    offscreen.start = walkerViewOf(readViewOption(choice.view));
  }
  offscreen.camera = choice.camera;
  printReport(exploreOffscreen(scene, script, std::move(offscreen)), choice, context);
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
  command.add_option("--camera", choice->camera, "What to begin with, by default the pinhole:" + cameras)
      ->type_name("NAME");
  addViewOption(command, choice->view);
  command
      .add_option("--metre", choice->metre,
                  "Units of the scene in a metre; by default 1, or so that the scene is 50 m across where it is less "
                  "than 4 m or more than 20 km")
      ->check(numberCheck(1e-6, 1e6))
      ->type_name("UNITS");
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
  command.add_flag("--window", choice->window, "With --offscreen: draw the whole window, with panes and texts");
  command.add_option("--scale", choice->scale, "With --window: how much larger texts are, as on a denser screen")
      ->check(numberCheck(0.5, 4))
      ->capture_default_str()
      ->type_name("FACTOR");
  addGlOption(command, choice->gl);
  command.add_option("--record", choice->video, "Record the window to a video from the first image on")
      ->type_name("FILE.mp4");
  command.add_option("-o,--output", choice->folder, "Folder for images, cameras and videos")->type_name("DIR");
  command.add_flag("--benchmark", choice->benchmark, "Draw every frame of the script, and print how long frames take");
  command.add_flag("--jumps", choice->jumps, "Print how many frames of the script change more than the pinhole's do");
  context.finish(command,
                 "  ocelli explore builtin:town\n"
                 "  ocelli explore house.glb --camera portal\n"
                 "  ocelli explore builtin:town --offscreen oc_core/explore/examples/town_walk.json -o frames\n"
                 "  ocelli explore builtin:maze --camera portal --offscreen walk.json --jumps",
                 [choice, context] { explore(*choice, context); });
}

}  // namespace ocelli
