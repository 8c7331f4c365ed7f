#include "cli/explore_window.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/gl_drawing.h"
#include "cli/number_check.h"
#include "oc_core/base/error.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/explore_window/explore_window_run.h"
#include "oc_core/explore_window/explore_window_session.h"
#include "oc_core/gl/gl_context.h"
#endif

namespace ocelli {

void addExploreWindowOptions(CLI::App& command, ExploreWindowChoice& choice) {
  command.add_flag("--window", choice.window, "With --offscreen: draw the whole window, with panes and texts");
  command.add_option("--scale", choice.scale, "With --window: how much larger texts are, as on a denser screen")
      ->check(numberCheck(0.5, 4))
      ->capture_default_str()
      ->type_name("FACTOR");
  addGlOption(command, choice.gl);
  command.add_option("--record", choice.video, "Record the window to a video from the first image on")
      ->type_name("FILE.mp4");
}

void checkExploreWindow(const ExploreWindowChoice& choice, bool plays, bool measures) {
  const auto require = [](bool given, bool holds, const std::string& option, const std::string& next) {
    if (given && !holds) {
      throw InputError("this option has no effect here", option, next);
    }
  };
  require(choice.window, plays, "--window", "give --offscreen SCRIPT.json; without it there is a window anyhow");
  require(choice.gl != "auto" || choice.scale != 1, choice.window, "--gl, --scale", "give --window with --offscreen");
  require(measures, plays && !choice.window, "--jumps, --changes", "give --offscreen SCRIPT.json, without --window");
  require(!choice.video.empty(), !plays, "--record", "a script has the step {\"record\": \"walk.mp4\"}");
}

#ifdef OCELLI_WITH_OPENGL
namespace {

ExplorerWindowOptions windowModelOf(const ExploreWindowWhat& what) {
  return {what.read, what.options.explorer, what.options.start, what.options.camera};
}

double percentileOf(const std::vector<double>& milliseconds, double share) {
  return ExploreTimes{milliseconds, std::vector<double>(milliseconds.size())}.percentile(share);
}

}  // namespace

void exploreInWindow(const ExploreWindowChoice& choice, const ExploreWindowWhat& what) {
  ExploreWindowRunOptions options;
  options.title = "Ocelli: " + what.source;
  options.model = windowModelOf(what);
  options.folder = what.options.folder;
  options.record = what.options.record;
  if (!choice.video.empty()) {
    options.video = choice.video;
  }
  options.wrote = what.options.wrote;
  runExploreWindow(options);
}

void playScriptInWindow(const ExploreWindowChoice& choice, const ExploreWindowWhat& what, const ExploreScript& script,
                        const CommandContext& context) {
  const std::unique_ptr<GlContext> gl = openGlContext(choice.gl, "--gl");
  const ExploreWindowTimes times = playInExploreWindow(*gl, script,
                                                       {.model = windowModelOf(what),
                                                        .folder = what.options.folder,
                                                        .contentScale = choice.scale,
                                                        .record = what.options.record,
                                                        .wrote = what.options.wrote});
  if (what.options.measureTimes) {
    context.print(
        fmt::format("frames            {}\nwalk and images   {:.1f} ms median, {:.1f} of 90 %\n"
                    "window            {:.1f} ms median, {:.1f} of 90 %, {:.1f} ms of all cores\n",
                    times.walk.size(), percentileOf(times.walk, 0.5), percentileOf(times.walk, 0.9),
                    percentileOf(times.window, 0.5), percentileOf(times.window, 0.9), times.windowCpu));
  }
}
#else
void exploreInWindow(const ExploreWindowChoice&, const ExploreWindowWhat&) {
  throw InputError("this program was built without OpenGL", "explore",
                   "give --offscreen SCRIPT.json, or build with -DOCELLI_WITH_OPENGL=ON");
}
void playScriptInWindow(const ExploreWindowChoice&, const ExploreWindowWhat&, const ExploreScript&,
                        const CommandContext&) {
  throw InputError("this program was built without OpenGL", "--window",
                   "leave it out, or build with -DOCELLI_WITH_OPENGL=ON");
}
#endif

}  // namespace ocelli
