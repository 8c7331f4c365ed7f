// What the image of a general pinhole camera (chapter 5) costs beside that of its pinhole, in the same run: drawn piece
// by piece, by subdivision, and along its rays against a standing acceleration structure. As Table 5.1, for scenes of
// growing triangle counts.
//
// Times are CPU time, summed over threads, the best of --runs, taken in turn for all: other work on the machine
// hardly counts. The view decides how much of the scene lies in the transition, where a triangle costs most.
#include <cstdio>
#include <functional>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct GpcBenchChoice {
  std::string scene = "builtin:statues,triangles={}";
  std::vector<size_t> triangles{100'000, 1'000'000};
  double fovDegrees = 5;  ///< of the closer view, which the scene fills
  int runs = 5;
  int threads = 1;
  int width = 1280;
  int height = 720;
  bool subdivide = true;
  std::string only;  ///< techniques whose names hold this, and the pinhole
};

struct GpcTechnique {
  std::string name;
  std::function<void()> draw;
  double best = 1e30;
};

GpcLayout remote(const char* sampling) {
  return {findGpcSampling(sampling), {{{0.5f, 0.5f}, {0.5f, 0.5f}, 3, 1}}};
}
GpcLayout lenses() {
  return {findGpcSampling("cubic"), {{{0.3f, 0.5f}, {0.2f, 0.3f}, 3, 0.8f}, {{0.75f, 0.5f}, {0.15f, 0.2f}, 6, 1}}};
}

/// n x n regions, which may be 16 x 16 at most.
GpcLayout manyLenses(int n) {
  GpcLayout layout{findGpcSampling("cubic"), {}};
  for (int i = 0; i < n * n; ++i) {
    const glm::vec2 cell(static_cast<float>(i % n), static_cast<float>(i / n));
    layout.regions.push_back({(cell + 0.5f) / static_cast<float>(n), glm::vec2(0.5f / static_cast<float>(n)), 2, 0.9f});
  }
  return layout;
}

void measureView(const GpcBenchChoice& choice, const char* viewName, const View& view, const Mesh& mesh,
                 const RayScene& rays) {
  const PinholeCamera pinhole(view, choice.width, choice.height);
  std::vector<GpcTechnique> techniques{{"pinhole", [&] { rasterize(pinhole, mesh); }}};
  std::vector<std::pair<std::string, GpcCamera>> cameras;
  for (const GpcSampling& each : gpcSamplings()) {
    cameras.emplace_back(std::string("centre 3x, ") + each.name, GpcCamera(pinhole, remote(each.name)));
  }
  cameras.emplace_back("lenses 3x, 6x, cubic", GpcCamera(pinhole, lenses()));
  cameras.emplace_back("64 lenses 2x, cubic", GpcCamera(pinhole, manyLenses(8)));
  cameras.emplace_back("256 lenses 2x, cubic", GpcCamera(pinhole, manyLenses(16)));
  for (const auto& [name, camera] : cameras) {
    techniques.push_back({name + ", pieces", [&camera = camera, &mesh] { rasterizeGpc(camera, mesh); }});
    techniques.push_back({name + ", rays", [&camera = camera, &mesh, &rays] { raycast(camera, mesh, rays); }});
    if (choice.subdivide) {
      techniques.push_back(
          {name + ", subdivided", [&camera = camera, &mesh] { rasterize(camera, mesh, gpcSubdivision(camera)); }});
    }
  }
  std::erase_if(techniques, [&](const GpcTechnique& each) {
    return &each != techniques.data() && each.name.find(choice.only) == std::string::npos;
  });
  for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
    for (GpcTechnique& technique : techniques) {
      const double time = processorMilliseconds(technique.draw);
      technique.best = run > 0 ? std::min(technique.best, time) : technique.best;
    }
  }
  for (const GpcTechnique& technique : techniques) {
    fmt::print("{:>10} {:<7} {:<36} {:>9.1f} ms {:>7.2f}\n", mesh.triangles.size(), viewName, technique.name,
               technique.best, technique.best / techniques.front().best);
  }
  std::fflush(stdout);
}

void measure(const GpcBenchChoice& choice) {
  for (const size_t triangles : choice.triangles) {
    const Mesh mesh = loadScene(fmt::format(fmt::runtime(choice.scene), triangles));
    const RayScene rays(mesh);
    measureView(choice, "whole", View{}, mesh, rays);
    View closer;
    closer.target = {0, -0.2f, 0};
    closer.fovVerticalDegrees = choice.fovDegrees;
    measureView(choice, "filled", closer, mesh, rays);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("The general pinhole camera beside the pinhole", "gpc_bench");
  ocelli::GpcBenchChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scene, "{} stands for the triangles");
  program.add_option("--triangles", choice.triangles, "How many")->delimiter(',');
  program.add_option("--fov", choice.fovDegrees, "Of the view that the scene fills, degrees")->capture_default_str();
  program.add_option("--only", choice.only, "Only the techniques whose names hold this, and the pinhole");
  program.add_flag("!--no-subdivision", choice.subdivide, "Leave subdivision out, which takes longest");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
