// What the cameras of chapter 4 cost beside a pinhole, in one run: a graph camera of seven frusta and curved ray
// cameras of 1, 2 and 8 turns, on the CPU and with OpenGL. Section 4.4 has 1.7 times a pinhole image at most for
// the graph camera, 2.1 times for the curved ray camera, on data sets of its own.
//
// All take turns, so that what else the machine does hits them alike; the first run is not counted. On the CPU a
// time is that of all threads together, which other work on the machine hardly changes; with OpenGL it is the time that
// passes until the GPU has finished, or where a CPU stands in for one its time. The best of --runs. "Blocks kept" draws
// with the boxes of blocks of triangles standing (mesh_blocks.h), as for a scene that is walked through; "pinhole, as a
// graph" is the same pinhole drawn as a graph camera of one frustum.
//
// --tables draws what the text's Tables 4.1 and 4.2 do, as far as our scenes go, with their figures beside ours; --walk
// is the mean of the images of a walk along the street, and the slowest, by the clock.
//
// To add a camera or a scene, add a line to kDefaults or kTables; standpoint() says from where a scene is seen.
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
  bool tables = false;
  bool walk = false;
};

/// A graph camera of so many frusta, or a curved ray camera of so many turns.
struct BenchCamera {
  int frusta = 0;
  int turns = 0;
  const char* text = "";  ///< the text's figure

  std::string name() const {
    return frusta == 1  ? "pinhole, as a graph"
           : frusta > 0 ? fmt::format("graph, {} frusta", frusta)
                        : fmt::format("curved, {} turn{}", turns, turns == 1 ? "" : "s");
  }
};

const std::vector<BenchCamera> kDefaults{{1, 0, ""}, {7, 0, ""}, {0, 1, ""}, {0, 2, ""}, {0, 8, ""}};

struct TableScene {
  const char* source;
  std::vector<BenchCamera> cameras;
};

/// Frames a second of Table 4.1; of Table 4.2 the ratios of times to the pinhole's.
const std::vector<TableScene> kTables{
    {"builtin:house,triangles=958000", {{1, 0, ""}, {6, 0, "27 Hz"}, {13, 0, "6.7 Hz"}}},
    {"builtin:town,detail=4", {{1, 0, ""}, {5, 0, "31 Hz"}, {7, 0, "25 Hz"}, {35, 0, "5.2 Hz"}}},
    {"builtin:city,triangles=4123000", {{1, 0, ""}, {12, 0, "12 Hz"}, {0, 1, "x 1.0"}}},
    {"builtin:boxes,count=3100,floor=1", {{1, 0, ""}, {7, 0, "x 1.13"}, {0, 1, "x 1.12"}}},
    {"builtin:dna,triangles=4112000", {{1, 0, ""}, {7, 0, "x 1.50"}, {0, 1, "x 2.09"}}},
    {"builtin:canyon,triangles=2168000",
     {{1, 0, ""}, {7, 0, "x 1.77"}, {0, 1, "x 1.90"}, {0, 3, ""}, {0, 5, ""}, {0, 7, "as 1 turn"}}},
};

using Work = std::function<void()>;

/// One camera, in each way that it can be drawn; empty where it cannot.
struct Row {
  std::string name;
  std::string text;
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
  } else if (source.starts_with("builtin:city") || source.starts_with("builtin:house")) {
    // At the eyes of who walks along the path, towards its first corner.
    const std::vector<glm::vec3>& path = scene.guides.path;
    const glm::vec3 lift(0, boundsOf(scene.mesh).lower.y + 1.6f - path[0].y, 0);
    street.view.eye = path[0] + lift;
    street.view.target = path[1] + lift;
    street.view.zNear = 0.05f;
    street.toCrossing = std::max(0.5 * static_cast<double>(glm::distance(path[0], path[1])), 2.0);
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
Row bentRow(const BenchCamera& bench, const C& camera, const Mesh& mesh, const MeshBlocks& blocks,
            const GlRenderer& renderer) {
  return {bench.name(), bench.text, [camera, &mesh] { rasterize(camera, mesh); },
          [camera, &mesh, &blocks] { rasterize(camera, mesh, blocks); },
          [camera, &renderer] { renderer.drawOnGpu(camera); }};
}

std::vector<Row> rowsOf(const Street& street, const std::vector<BenchCamera>& cameras, const BenchChoice& choice,
                        const Mesh& mesh, const MeshBlocks& blocks, const GlRenderer& renderer) {
  const PinholeCamera pinhole(street.view, choice.width, choice.height);
  std::vector<Row> rows{
      {"pinhole", "", [=, &mesh] { rasterize(pinhole, mesh); }, {}, [=, &renderer] { renderer.drawOnGpu(pinhole); }}};
  for (const BenchCamera& camera : cameras) {
    rows.push_back(
        camera.frusta > 0
            ? bentRow(camera, graphOf(street, choice.width, choice.height, camera.frusta), mesh, blocks, renderer)
            : bentRow(camera, streetCurves(street, choice.width, choice.height, camera.turns), mesh, blocks, renderer));
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
      const auto draw = [&] {
        row.onGpu();
        context.gl().Finish();
      };
      const double gpu = context.info().isSoftware ? processorMilliseconds(draw) : milliseconds(draw);
      if (run > 0) {
        row.plainMs = std::min(row.plainMs, plain);
        row.blocksKeptMs = std::min(row.blocksKeptMs, kept);
        row.gpuMs = std::min(row.gpuMs, gpu);
      }
    }
  }
  nlohmann::ordered_json results;
  for (const Row& row : rows) {
    fmt::print("{:<20} {} {} {} {:>10}\n", row.name, cell(row.plainMs, rows[0].plainMs),
               cell(row.blocksKeptMs, rows[0].plainMs), cell(row.gpuMs, rows[0].gpuMs), row.text);
    nlohmann::ordered_json result{{"camera", row.name}, {"processorMs", row.plainMs}, {"glMs", row.gpuMs}};
    if (row.blocksKept) {
      result["blocksKeptMs"] = row.blocksKeptMs;
    }
    results.push_back(result);
  }
  std::fflush(stdout);
  return results;
}

/// Images of a walk of a fifth of the way to the crossing, with the graph camera of seven frusta.
void measureWalk(const Street& street, const BenchChoice& choice, const Mesh& mesh, const MeshBlocks& blocks) {
  constexpr int kFrames = 60;
  double sum = 0;
  double most = 0;
  double processor = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    Street step = street;
    const glm::vec3 ahead = glm::normalize(street.view.target - street.view.eye);
    const float way = 0.2f * static_cast<float>(street.toCrossing * frame) / kFrames;
    step.view.eye += ahead * way;
    step.view.target += ahead * way;
    step.toCrossing -= static_cast<double>(way);
    const GraphCamera camera = streetGraph(step, choice.width, choice.height);
    processor += processorMilliseconds([&] {
      const double ms = milliseconds([&] { rasterize(camera, mesh, blocks); });
      sum += ms;
      most = std::max(most, ms);
    });
  }
  fmt::print("walk with 7 frusta, {} images: {:.1f} ms each by the clock, {:.1f} at most, {:.1f} ms of CPU time\n",
             kFrames, sum / kFrames, most, processor / kFrames);
  std::fflush(stdout);
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
  std::vector<std::pair<std::string, std::vector<BenchCamera>>> scenes;
  for (const std::string& source : choice.scenes) {
    if (!choice.tables) {
      scenes.emplace_back(source, kDefaults);
    }
  }
  for (const TableScene& scene : kTables) {
    if (choice.tables) {
      scenes.emplace_back(scene.source, scene.cameras);
    }
  }
  for (const auto& [source, cameras] : scenes) {
    const bool fits = source.starts_with("builtin:boxes") || source.starts_with("builtin:dna");
    const GuidedScene scene = loadGuidedScene(source, {.fit = fits});
    const MeshBlocks blocks(scene.mesh, MeshBlocks::Order::kInSpace);
    const Street street = standpoint(source, scene);
    fmt::print("\n{}, {} triangles\n", source, scene.mesh.triangles.size());
    if (choice.walk) {
      measureWalk(street, choice, scene.mesh, blocks);
      continue;
    }
    fmt::print("{:<20} {:>15} {:>15} {:>15} {:>10}\n", "ms, x pinhole", "CPU", "blocks kept", "OpenGL", "text");
    const GlRenderer renderer(*context, scene.mesh);
    const auto rows = rowsOf(street, cameras, choice, scene.mesh, blocks, renderer);
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
  program.add_flag("--tables", choice.tables, "The rows of the text's Tables 4.1 and 4.2 in place of the scenes");
  program.add_flag("--walk", choice.walk, "Images of a walk on the CPU");
  program.add_option("--json", choice.json, "Write the same figures to a file");
  return runProgram(program, argumentCount, arguments, choice, measureScenes);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
