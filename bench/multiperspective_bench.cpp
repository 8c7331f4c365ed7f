// What the cameras of chapter 4 cost beside a pinhole, in one run: a graph camera of seven frusta and curved ray
// cameras of 1, 2 and 8 turns, on the CPU and with OpenGL. Section 4.4 has 1.7 times a pinhole image at most for
// the graph camera, 2.1 times for the curved ray camera, on data sets of its own.
//
// All take turns, so that what else the machine does hits them alike; the first run is not counted. On the CPU a
// time is that of all threads together, which other work on the machine hardly changes; with OpenGL it is the time that
// passes until the GPU has finished. The best of --runs. "Blocks kept" draws with the boxes of blocks of triangles
// standing (mesh_blocks.h), as for a scene that is walked through; "pinhole, as a graph" is the same pinhole drawn as a
// graph camera of one frustum.
//
// To add a camera, add a line to rowsOf(); to add a scene, one to standpoint().
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/street_cameras.h"
#include "bench/timing.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_renderer.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct BenchChoice {
  std::vector<std::string> scenes{"builtin:town", "builtin:canyon", "builtin:boxes,count=700,floor=1"};
  std::string provider = "auto";
  std::string json;
  int runs = 5;
  int threads = 0;
  int width = 1280;
  int height = 720;
};

using Work = std::function<void()>;

/// One camera, in each way that it can be drawn; empty where it cannot.
struct Row {
  std::string name;
  Work plain;
  Work blocksKept;
  Work onGpu;
  double plainMs = 1e30;
  double blocksKeptMs = 1e30;
  double gpuMs = 1e30;
};

/// Where one stands in a scene: at a crossing of streets, at the start of a path, or before the whole of it.
Street standpoint(const std::string& source, const GuidedScene& scene) {
  Street street;
  street.view.fovVerticalDegrees = 31.5;
  if (source.starts_with("builtin:town")) {
    street.view.eye = {0, 2.5f, 40};
    street.view.target = {0, 2.5f, 0};
    street.view.zNear = 0.1f;
    street.toCrossing = 22;
  } else if (scene.guides.path.size() > 1) {
    const float length = glm::distance(scene.guides.path.front(), scene.guides.path.back());
    const glm::vec3 above(0, 0.02f * length, 0);  // the water
    street.view.eye = scene.guides.path.front() + above;
    street.view.target = scene.guides.path[scene.guides.path.size() / 5] + above;
    street.view.zNear = 1e-3f * length;
    street.toCrossing = 0.15 * static_cast<double>(length);
  } else {
    const Box box = boundsOf(scene.mesh);
    street.view.target = box.center();
    street.view.eye = box.center() + glm::vec3(0, 0.2f, 1) * glm::length(box.size());
    street.toCrossing = static_cast<double>(glm::length(box.size()));
  }
  return street;
}

template <Camera C>
Row bentRow(const std::string& name, const C& camera, const Mesh& mesh, const MeshBlocks& blocks,
            const GlRenderer& renderer) {
  return {name, [camera, &mesh] { rasterize(camera, mesh); },
          [camera, &mesh, &blocks] { rasterize(camera, mesh, blocks); },
          [camera, &renderer] { renderer.drawOnGpu(camera); }};
}

std::vector<Row> rowsOf(const Street& street, const BenchChoice& choice, const Mesh& mesh, const MeshBlocks& blocks,
                        const GlRenderer& renderer) {
  const PinholeCamera pinhole(street.view, choice.width, choice.height);
  std::vector<Row> rows{
      {"pinhole", [=, &mesh] { rasterize(pinhole, mesh); }, {}, [=, &renderer] { renderer.drawOnGpu(pinhole); }}};
  rows.push_back(bentRow("pinhole, as a graph", GraphCamera(pinhole), mesh, blocks, renderer));
  rows.push_back(bentRow("graph, 7 frusta", streetGraph(street, choice.width, choice.height), mesh, blocks, renderer));
  for (const int turns : {1, 2, 8}) {
    rows.push_back(bentRow(fmt::format("curved, {} turn{}", turns, turns == 1 ? "" : "s"),
                           streetCurves(street, choice.width, choice.height, turns), mesh, blocks, renderer));
  }
  return rows;
}

/// A time and its ratio to that of the pinhole.
std::string cell(double ms, double pinholeMs) {
  return ms < 1e29 ? fmt::format("{:>8.1f} {:>6.2f}", ms, ms / pinholeMs) : fmt::format("{:>15}", "");
}

/// Runs all in turn, and prints the best times.
nlohmann::ordered_json measure(GlContext& context, std::vector<Row> rows, int runs) {
  for (int run = 0; run <= runs; ++run) {  // the first is not counted
    for (Row& row : rows) {
      const double plain = processorMilliseconds(row.plain);
      const double kept = row.blocksKept ? processorMilliseconds(row.blocksKept) : 1e30;
      const double gpu = milliseconds([&] {
        row.onGpu();
        context.gl().Finish();
      });
      if (run > 0) {
        row.plainMs = std::min(row.plainMs, plain);
        row.blocksKeptMs = std::min(row.blocksKeptMs, kept);
        row.gpuMs = std::min(row.gpuMs, gpu);
      }
    }
  }
  nlohmann::ordered_json results;
  for (const Row& row : rows) {
    fmt::print("{:<20} {} {} {}\n", row.name, cell(row.plainMs, rows[0].plainMs),
               cell(row.blocksKeptMs, rows[0].plainMs), cell(row.gpuMs, rows[0].gpuMs));
    nlohmann::ordered_json result{{"camera", row.name}, {"processorMs", row.plainMs}, {"glMs", row.gpuMs}};
    if (row.blocksKept) {
      result["blocksKeptMs"] = row.blocksKeptMs;
    }
    results.push_back(result);
  }
  std::fflush(stdout);
  return results;
}

void measureScenes(const BenchChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const GlScope scope(*context);
  const GlInfo& info = context->info();
  fmt::print("{}x{}, {} threads, best of {} runs; {} through {}, {}\n", choice.width, choice.height, threadCount(),
             choice.runs, info.renderer, nameOf(info.provider), info.isSoftware ? "a software renderer" : "a GPU");
  nlohmann::ordered_json report{{"renderer", info.renderer},
                                {"isSoftware", info.isSoftware},
                                {"width", choice.width},
                                {"height", choice.height},
                                {"threads", threadCount()},
                                {"runs", choice.runs},
                                {"scenes", nlohmann::ordered_json::array()}};
  for (const std::string& source : choice.scenes) {
    const GuidedScene scene = loadGuidedScene(source, {.fit = source.starts_with("builtin:boxes")});
    const MeshBlocks blocks(scene.mesh);
    const GlRenderer renderer(*context, scene.mesh);
    fmt::print("\n{}, {} triangles\n{:<20} {:>15} {:>15} {:>15}\n", source, scene.mesh.triangles.size(),
               "ms, x pinhole", "CPU", "blocks kept", "OpenGL");
    const auto rows = rowsOf(standpoint(source, scene), choice, scene.mesh, blocks, renderer);
    report["scenes"].push_back({{"scene", source},
                                {"triangles", scene.mesh.triangles.size()},
                                {"results", measure(*context, rows, choice.runs)}});
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, report.dump(2) + "\n");
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Images of the graph camera and of the curved ray camera, beside those of a pinhole.",
                   "multiperspective_bench");
  BenchChoice choice;
  program.add_option("--scenes", choice.scenes, "Scenes")->delimiter(';')->capture_default_str();
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
