// How many frames a second the viewer draws, at rest and while something moves: drawn as for a window, without one. A
// frame ends when the GPU has finished. Nothing is built while frames are counted: what builds is on other threads, and
// the window never waits for it.
//
// To add a situation, add a line to situations().
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/viewer/viewer.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {
namespace {

constexpr double kFrameSeconds = 1.0 / 60;

struct BenchChoice {
  std::string scene = "builtin:statues,triangles={}";
  std::vector<size_t> triangles{400'000, 1'000'000, 4'600'000};
  std::string camera = "ddoc";
  std::string provider = "auto";
  std::string json;
  int runs = 120;
  int threads = 0;
  int width = 1280;
  int height = 800;
};

/// What is pressed before frames are counted, and before each of them.
struct Situation {
  const char* what;
  std::vector<KeyEvent> before;
  std::vector<KeyEvent> eachFrame;
};

std::vector<Situation> situations() {
  const KeyEvent runOrStop{Key::kSpace, true, {}};  // it runs at first
  const KeyEvent slower{Key::kComma, true, {}};
  const KeyEvent turn{Key::kLeft, true, {}};
  const KeyEvent all{Key::k0, true, {}};
  const KeyEvent scene{Key::k1, true, {}};
  const KeyEvent reconstruction{Key::k3, true, {}};
  const KeyEvent display{Key::k4, true, {}};
  return {{"four panes, display at full speed", {}, {}},
          {"four panes, display at an eighth of its speed", {slower, slower, slower}, {}},
          {"four panes, nothing moves", {runOrStop}, {}},
          {"four panes, the scene turns", {scene, all}, {turn}},
          {"four panes, the eye turns", {reconstruction, all}, {turn}},
          {"scene alone, turning", {scene}, {turn}},
          {"reconstruction alone, the eye turns", {reconstruction}, {turn}},
          {"display alone, turning", {display}, {turn}},
          {"display alone, at an eighth of its speed, turning", {runOrStop}, {turn}}};
}

struct FrameTimes {
  double medianMs = 0;
  double slowMs = 0;  ///< 95 % take no longer
  double inTime = 0;  ///< share that took 1/60 s at most
};

FrameTimes summaryOf(std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const size_t count = milliseconds.size();
  const auto late = std::upper_bound(milliseconds.begin(), milliseconds.end(), 1000 * kFrameSeconds);
  return {milliseconds[count / 2], milliseconds[(count - 1) * 95 / 100],
          static_cast<double>(late - milliseconds.begin()) / static_cast<double>(count)};
}

void press(Viewer& viewer, const std::vector<KeyEvent>& keys) {
  for (const KeyEvent& key : keys) {
    viewer.handle(key);
    viewer.handle(KeyEvent{key.key, false, key.modifiers});
  }
}

/// Until everything is made and shown.
void comeToRest(Viewer& viewer) {
  do {
    viewer.waitUntilMade();
    viewer.update(0);
    viewer.draw();
  } while (viewer.facts().work.busy || viewer.hasWaitingEvents() || viewer.isSettling());
}

FrameTimes timesOf(GlContext& context, Viewer& viewer, const Situation& situation, int frames) {
  press(viewer, situation.before);
  comeToRest(viewer);
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame) {
    times.push_back(milliseconds([&] {
      press(viewer, situation.eachFrame);
      viewer.update(kFrameSeconds);
      viewer.draw();
      const GlScope scope(context);
      context.gl().Finish();
    }));
  }
  return summaryOf(times);
}

void measureScenes(const BenchChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const GlInfo& info = context->info();
  fmt::print("{} through {}, {}; {}x{}, camera {}, {} frames each\n\n{:>10} {:<48} {:>9} {:>9} {:>12}\n", info.renderer,
             nameOf(info.provider), info.isSoftware ? "a software renderer" : "a GPU", choice.width, choice.height,
             choice.camera, choice.runs, "triangles", "", "median ms", "95 % ms", "within 1/60");
  nlohmann::ordered_json report{{"renderer", info.renderer},
                                {"isSoftware", info.isSoftware},
                                {"width", choice.width},
                                {"height", choice.height},
                                {"camera", choice.camera},
                                {"frames", choice.runs},
                                {"results", nlohmann::ordered_json::array()}};
  for (const size_t triangles : choice.triangles) {
    ViewerOptions options;
    options.source = fmt::format(fmt::runtime(choice.scene), triangles);
    options.camera = cameraChoice(choice.camera);
    Viewer viewer(*context, options);
    viewer.handle(ResizeEvent{choice.width, choice.height, 1, 1});
    comeToRest(viewer);
    for (const Situation& situation : situations()) {
      const FrameTimes times = timesOf(*context, viewer, situation, choice.runs);
      fmt::print("{:>10} {:<48} {:>9.2f} {:>9.2f} {:>10.1f} %\n", triangles, situation.what, times.medianMs,
                 times.slowMs, 100 * times.inTime);
      report["results"].push_back({{"triangles", triangles},
                                   {"what", situation.what},
                                   {"medianMs", times.medianMs},
                                   {"slowMs", times.slowMs},
                                   {"withinSixtieth", times.inTime}});
      std::fflush(stdout);
    }
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, report.dump(2) + "\n");
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Frames a second of the viewer.", "viewer_frames_bench");
  BenchChoice choice;
  program.add_option("--scene", choice.scene, "Scene, with {} for the triangle count")->capture_default_str();
  program.add_option("--triangles", choice.triangles, "Triangle counts")->delimiter(',')->capture_default_str();
  program.add_option("--camera", choice.camera, "Camera")->capture_default_str();
  program.add_option("--provider", choice.provider, "auto, egl or osmesa")->capture_default_str();
  addCommonOptions(program, choice);
  program.add_option("--json", choice.json, "Write the same figures to a file");
  return runProgram(program, argumentCount, arguments, choice, measureScenes);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
