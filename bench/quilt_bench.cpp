// Quilts for light-field displays: the time for all views from epipolar images, against that of rendering them one by
// one, and what they lack, against what a display makes of colour and depth.
//
// Steps are timed on the clock and on the CPU (all threads together); the least of several runs counts. Where the scene
// stands still, the acceleration structure stands too: its time is told apart.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/quilt/color_and_depth.h"
#include "display_sim/quilt/quilt_errors.h"
#include "display_sim/quilt/quilt_images.h"
#include "display_sim/quilt/quilt_render.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct QuiltBenchChoice {
  std::string scene = "builtin:statues";
  std::string display = "portrait";
  std::vector<int> images{1, 2};
  std::vector<double> samplings{1};
  std::vector<std::string> constructions{"raster", "rays"};
  int runs = 3;
  int threads = 0;
  bool skipsRenders = false;
  bool skipsErrors = false;
  std::string json;
};

struct StepTime {
  double clock = 1e30;
  double cpu = 1e30;

  template <class Work>
  void measure(int runs, const Work& work) {
    for (int i = 0; i < runs; ++i) {
      double ofCpu = 0;
      const double now = milliseconds([&] { ofCpu = processorMilliseconds(work); });
      clock = std::min(clock, now);
      cpu = std::min(cpu, ofCpu);
    }
  }
  Json json() const { return {{"clock_ms", clock}, {"cpu_ms", cpu}}; }
  std::string text() const { return fmt::format("{:>8.0f} {:>8.0f}", clock, cpu); }
};

/// One row of the table of times: how its images were made, and how many.
struct QuiltRun {
  std::string name;
  StepTime images;
  StepTime views;
  QuiltPicture picture;
  size_t samples = 0;
  int width = 0;

  double clock() const { return images.clock + views.clock; }
  double cpu() const { return images.cpu + views.cpu; }
};

QuiltRun runOf(const QuiltBenchChoice& choice, const QuiltViews& views, const Mesh& scene,
               const QuiltImageOptions& options, const SceneRenderer* renderer) {
  QuiltRun run;
  run.name = fmt::format("eoc-h x{}, {}{}", options.images, renderer != nullptr ? "rays" : "raster",
                         options.sampling == 1 ? "" : fmt::format(", sampling {:g}", options.sampling));
  std::vector<QuiltLines> lines;
  run.images.measure(choice.runs, [&] { lines = quiltLines(views, scene, options, renderer); });
  run.views.measure(choice.runs, [&] { run.picture = quiltFromLines(views, lines); });
  run.picture = quiltFromLines(views, lines, QuiltDepths::kKept);
  for (const QuiltLines& each : lines) {
    run.samples += each.samples;
    run.width = std::max(run.width, each.width);
  }
  return run;
}

void printErrors(const std::vector<std::string>& names, const std::vector<FrameErrors>& errors, Json& json) {
  fmt::print("\n{:<28} {:>9} {:>9} {:>8} {:>8}\n", "by", "missing %", "thick %", "FLIP", "PSNR dB");
  for (size_t i = 0; i < names.size(); ++i) {
    const FrameErrors& e = errors[i];
    fmt::print("{:<28} {:>9.3f} {:>9.3f} {:>8.4f} {:>8.2f}\n", names[i], 100 * e.strictRatio(), 100 * e.thickRatio(),
               e.meanFlip(), e.meanPsnrDecibels());
    json["errors"].push_back({{"by", names[i]},
                              {"missing_strict", e.strictRatio()},
                              {"missing_thick", e.thickRatio()},
                              {"flip", e.meanFlip()},
                              {"psnr_db", e.meanPsnrDecibels()}});
  }
}

void measure(const QuiltBenchChoice& choice) {
  const QuiltViews views(loadQuiltDisplay(choice.display), View{});
  const QuiltDisplay& display = views.display();
  Mesh scene = loadScene(choice.scene);
  views.stretchScene(scene, views.stretch());
  fmt::print("{}: {} triangles; {} views of {}x{}, {:g} degrees; {} threads\n", choice.scene, scene.triangles.size(),
             views.count(), display.tileWidth(), display.tileHeight(), display.coneDegrees, threadCount());
  Json json{{"scene", choice.scene}, {"triangles", scene.triangles.size()}, {"display", display.name}};

  StepTime renders;
  QuiltPicture rendered;
  if (!choice.skipsRenders) {
    renders.measure(1, [&] { rendered = quiltByRender(views, scene); });
    json["renders"] = renders.json();
  }
  std::vector<QuiltRun> runs;
  fmt::print(
      "\n{:<28} {:>17} {:>17} {:>17}\n{:<28} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7} {:>9} {:>6} {:>6}\n", "",
      "images, ms", "views, ms", "together, ms", "by", "clock", "CPU", "clock", "CPU", "clock", "CPU", "x", "x CPU",
      "samples", "width", "gaps %");
  if (!choice.skipsRenders) {
    fmt::print("{:<28} {:>17} {:>17} {}\n", "render", "", "", renders.text());
  }
  for (const double sampling : choice.samplings) {
    Mesh wider;
    if (sampling != 1) {
      wider = scene;
      views.stretchScene(wider, sampling);
    }
    const Mesh& world = sampling == 1 ? scene : wider;
    std::unique_ptr<RayScene> rays;
    const double structure = milliseconds([&] { rays = std::make_unique<RayScene>(world); });
    const RayRenderer renderer(world, *rays);
    for (const int images : choice.images) {
      for (const std::string& construction : choice.constructions) {
        const SceneRenderer* by = construction == "rays" ? &renderer : nullptr;
        QuiltImageOptions options;
        options.images = images;
        options.sampling = sampling;
        runs.push_back(runOf(choice, views, world, options, by));
        const QuiltRun& run = runs.back();
        fmt::print("{:<28} {} {} {:>8.0f} {:>8.0f}", run.name, run.images.text(), run.views.text(), run.clock(),
                   run.cpu());
        if (!choice.skipsRenders) {
          fmt::print(" {:>7.1f} {:>7.1f}", renders.clock / run.clock(), renders.cpu / run.cpu());
        }
        fmt::print(" {:>9} {:>6} {:>6.2f}\n", run.samples, run.width, 100 * run.picture.filledRatio(views));
        std::fflush(stdout);
        json["runs"].push_back({{"by", run.name},
                                {"images", run.images.json()},
                                {"views", run.views.json()},
                                {"samples", run.samples},
                                {"width", run.width},
                                {"filled", run.picture.filledRatio(views)}});
      }
    }
    fmt::print("(the structure that rays are cast at took {:.0f} ms on the clock)\n", structure);
  }
  if (!choice.skipsErrors) {
    const ReferenceImage middle = middleDepthImage(views, scene);
    const QuiltPicture exact = quiltFromDepthImage(views, middle, QuiltDepths::kKept);
    const QuiltPicture pair =
        quiltFromDepthImage(views, depthImageOf(colorAndDepth(middle), views), QuiltDepths::kKept);
    std::vector<std::string> names;
    std::vector<const QuiltPicture*> pictures;
    for (const QuiltRun& run : runs) {
      names.push_back(run.name);
      pictures.push_back(&run.picture);
    }
    names.insert(names.end(), {"di (exact depths)", "rgbd (8 bits)"});
    pictures.insert(pictures.end(), {&exact, &pair});
    printErrors(names, quiltErrors(views, scene, pictures), json);
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, json.dump(2) + "\n");
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  using namespace ocelli;
  QuiltBenchChoice choice;
  CLI::App program("Quilts from epipolar images against rendered ones: times and errors.", "quilt_bench");
  program.add_option("--scene", choice.scene, "As `ocelli` takes it")->capture_default_str();
  program.add_option("--display", choice.display, "Name or file")->capture_default_str();
  program.add_option("--images", choice.images, "1, 2, or both")->delimiter(',');
  program.add_option("--sampling", choice.samplings, "Samples for each pixel along rows")->delimiter(',');
  program.add_option("--construction", choice.constructions, "How images are drawn: raster, rays, or both")
      ->delimiter(',')
      ->check(CLI::IsMember({"raster", "rays"}));
  program.add_option("--runs", choice.runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  program.add_flag("--no-renders", choice.skipsRenders, "Leave out the time of rendering every view");
  program.add_flag("--no-errors", choice.skipsErrors, "Leave out the comparison of images");
  program.add_option("--json", choice.json, "Also write the figures here");
  return runProgram(program, argumentCount, arguments, choice, measure);
}
