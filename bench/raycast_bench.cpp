// Reference images of one scene at growing triangle counts: ray-cast against a standing acceleration structure, next to
// rasterisation, points and hybrid ray casting (chapter 6) in the same run; then whole constructions ("ddoc-" is the
// DDOC without feedback), camera and image, by rays and by rasterisation.
//
// What it shows: the cost of a ray-cast image is bounded by its pixels, that of the others grows with the scene. Times
// are processor time, summed over threads, the best of --runs, taken in turn for all techniques: other work on the
// machine hardly counts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/hybrid_raycast.h"
#include "oc_core/render/points.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct BenchChoice {
  std::string scene = "builtin:statues,triangles={}";
  std::vector<size_t> triangles{300'000, 4'000'000, 10'000'000};
  int runs = 3;
  int threads = 1;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  bool drawing = true;
};

struct Technique {
  const char* name;
  std::function<void()> draw;
  const char* camera;
  double best = 1e30;
};

/// Best times of each technique, ray casting first.
using Times = std::vector<double>;

/// Runs all in turn, prints the best times, and returns those of the first scene.
Times report(std::vector<Technique>& techniques, const Camera auto& camera, const Mesh& mesh, int runs,
             const Times& smallest) {
  for (int run = 0; run <= runs; ++run) {  // the first is not counted
    for (Technique& technique : techniques) {
      const double time = processorMilliseconds(technique.draw);
      technique.best = run > 0 ? std::min(technique.best, time) : technique.best;
    }
  }
  Times times;
  for (const Technique& technique : techniques) {
    const size_t i = times.size();
    times.push_back(technique.best);
    fmt::print("{:>12} {:<5} {:<13} {:>9.1f} {:>9.2f} {:>9.1f}\n", mesh.triangles.size(), technique.camera,
               technique.name, technique.best, technique.best / (smallest.empty() ? times[i] : smallest[i]),
               camera.width() * camera.height() / technique.best / 1000);
  }
  std::fflush(stdout);
  return smallest.empty() ? times : smallest;
}

template <Camera C>
Times measure(const char* cameraName, const C& camera, const Mesh& mesh, const RayScene& rays, int runs,
              const Times& smallest) {
  std::vector<Technique> techniques{
      {"ray casting", [&] { raycast(camera, mesh, rays); }, cameraName},
      {"of it, paths", [&] { RayPathTable{camera}; }, cameraName},
      {"rasterised", [&] { rasterize(camera, mesh); }, cameraName},
      {"hybrid", [&] { hybridRaycast(camera, mesh); }, cameraName},
      {"points", [&] { renderPoints(camera, mesh); }, cameraName},
  };
  return report(techniques, camera, mesh, runs, smallest);
}

/// Whole reference images, camera and image, with the acceleration structure standing and without.
void measureConstruction(const PinholeCamera& pinhole, const Mesh& mesh, const RayScene& rays, int runs,
                         Times& smallest) {
  const ViewSegment segment = segmentAround(pinhole.view(), kHorizontalSegment, CameraChoice{}.cellSideRadii);
  DdocOptions withoutFeedback;
  withoutFeedback.feedbackRounds = 0;
  std::vector<Technique> techniques;
  const RayRenderer renderer(mesh, rays);
  for (const SceneRenderer* by :
       {static_cast<const SceneRenderer*>(&renderer), static_cast<const SceneRenderer*>(nullptr)}) {
    const char* how = by != nullptr ? "built, rays" : "built, raster";
    techniques.push_back({how, [&, by] { buildDepthImage(pinhole, mesh, by); }, "di"});
    techniques.push_back({how, [&, by] { buildSpocImage(buildSpocCamera(pinhole, mesh, {}, by), mesh, by); }, "spoc"});
    techniques.push_back({how, [&, by] { buildDdocImage(pinhole, mesh, {}, {}, by); }, "ddoc"});
    techniques.push_back({how, [&, by] { buildDdocImage(pinhole, mesh, withoutFeedback, {}, by); }, "ddoc-"});
    techniques.push_back({how, [&, by] { buildEocImage(pinhole, segment, mesh, {}, by); }, "eoc-h"});
    techniques.push_back(
        {how, [&, by] { buildCellImage(buildCellCamera(pinhole, mesh, {}, {}, by), mesh, by); }, "cell"});
  }
  smallest = report(techniques, pinhole, mesh, runs, smallest);
}

void measureScenes(const BenchChoice& choice) {
  fmt::print("{} threads, {}x{}, best of {} runs\n\n", threadCount(), choice.width, choice.height, choice.runs);
  fmt::print("{:>12} {:<5} {:<13} {:>9} {:>9} {:>9}\n", "triangles", "", "", "ms", "x first", "Mpixel/s");
  std::array<Times, 3> smallest;
  Times smallestConstruction;
  for (const size_t triangles : choice.triangles) {
    const Mesh mesh = loadScene(fmt::format(fmt::runtime(choice.scene), triangles));
    for (const auto quality : {RayScene::Quality::kLow, RayScene::Quality::kMedium}) {
      fmt::print("{:>12} {:<5} {:<13} {:>9.1f}\n", mesh.triangles.size(), "",
                 quality == RayScene::Quality::kLow ? "build, low" : "build, medium", processorMilliseconds([&] {
                   RayScene{mesh, quality};
                 }));
    }
    const RayScene rays(mesh);
    const PinholeCamera pinhole(View{}, choice.width, choice.height);
    if (choice.drawing) {
      smallest = {measure("di", pinhole, mesh, rays, choice.runs, smallest[0]),
                  measure("spoc", SpocCamera::aroundObject(pinhole, mesh.positions, mesh.positions), mesh, rays,
                          choice.runs, smallest[1]),
                  measure("ddoc", buildDdocCamera(pinhole, mesh), mesh, rays, choice.runs, smallest[2])};
    }
    measureConstruction(pinhole, mesh, rays, choice.runs, smallestConstruction);
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Ray casting against a standing acceleration structure, at growing triangle counts.",
                   "raycast_bench");
  BenchChoice choice;
  program.add_option("--scene", choice.scene, "Scene, with {} for the triangle count")->capture_default_str();
  program.add_option("--triangles", choice.triangles, "Triangle counts")->delimiter(',')->capture_default_str();
  addCommonOptions(program, choice);
  program.add_flag("!--no-drawing", choice.drawing, "Measure whole constructions only");
  return runProgram(program, argumentCount, arguments, choice, measureScenes);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
