// What OpenGL costs beside the CPU, in one run: images of given cameras, whole constructions, and the whole way
// from a scene to a volume that is looked at, stage by stage.
//
// Both take turns, so that what else the machine does hits both alike; the first run, in which drivers compile shaders,
// is not counted. A time is the best of --runs and ends when the GPU has finished. Images of given cameras stay on the
// GPU; constructions read back all that they draw.
//
// To add a row, add a line to imageRows(), constructionRows() or wayRows().
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/gl/gl_observer.h"
#include "display_sim/gl/gl_slicer.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/gl_renderer.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_spans.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct BenchChoice {
  std::string scene = "builtin:statues,triangles={}";
  std::vector<size_t> triangles{150'000, 1'000'000, 4'600'000};
  std::string provider = "auto";
  std::string profile = "perspecta";
  std::string json;
  int runs = 5;
  int threads = 0;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
};

using Work = std::function<void()>;

struct Row {
  std::string what;
  Work onGpu;
  Work onCpu;  ///< empty where the GPU alone has to do it
  double gpuMs = 1e30;
  double processorMs = 1e30;
};

/// A scene on both sides, with the cameras that are given for its images.
struct Case {
  Case(GlContext& context, const std::string& source, const BenchChoice& choice)
      : mesh(loadScene(source)),
        pinhole(View{}, choice.width, choice.height),
        spoc(buildSpocCamera(pinhole, mesh)),
        ddoc(buildDdocCamera(pinhole, mesh)),
        eoc(buildEpipolarCamera(pinhole,
                                segmentAround(pinhole.view(), kHorizontalSegment, CameraChoice{}.cellSideRadii), mesh)),
        renderer(context, mesh),
        profile(loadProfile(choice.profile)) {}

  Mesh mesh;
  PinholeCamera pinhole;
  SpocCamera spoc;
  DdocCamera ddoc;
  EpipolarCamera eoc;
  GlRenderer renderer;
  DisplayProfile profile;
};

template <Camera C>
Row imageRow(const char* what, const Case& c, const C& camera) {
  return {what, [&] { c.renderer.drawOnGpu(camera); }, [&] { rasterize(camera, c.mesh); }};
}

std::vector<Row> imageRows(GlContext& context, const Case& c) {
  return {{"upload",
           [&] {
             GlMesh{context, c.mesh};
           },
           {}},
          imageRow("image, pinhole", c, c.pinhole),
          imageRow("image, spoc", c, c.spoc),
          imageRow("image, ddoc", c, c.ddoc),
          imageRow("image, eoc-h", c, c.eoc)};
}

Row constructionRow(const std::string& what, const Case& c, const CameraChoice& choice) {
  return {what, [&c, choice] { buildReferenceImages(choice, c.pinhole, c.mesh, {}, c.renderer); },
          [&c, choice] { buildReferenceImages(choice, c.pinhole, c.mesh, {}, Construction::kRaster, nullptr); }};
}

/// Constructions, and what the DDOC's takes of drawing: the depth image, and the first image of its feedback.
std::vector<Row> constructionRows(const Case& c) {
  std::vector<Row> rows;
  for (const char* name : {"di", "spoc", "eoc-h"}) {
    rows.push_back(constructionRow(fmt::format("construct {}", name), c, cameraChoice(name)));
  }
  CameraChoice plain = cameraChoice("ddoc");
  plain.ddoc.feedbackRounds = 0;
  rows.push_back(constructionRow("construct ddoc, no feedback", c, plain));
  rows.push_back(constructionRow("construct ddoc", c, cameraChoice("ddoc")));
  rows.push_back({"of it: camera", [&] { buildDdocCamera(c.pinhole, c.mesh, {}, {}, &c.renderer); },
                  [&] { buildDdocCamera(c.pinhole, c.mesh); }});
  rows.push_back({"of that: depth image", [&] { c.renderer.draw(c.pinhole); }, [&] { rasterize(c.pinhole, c.mesh); }});
  const FragmentImage seen = rasterize(c.pinhole, c.mesh);
  const SubdivisionOptions coarse = DdocOptions{}.feedbackSubdivision;
  rows.push_back({"of that: feedback's image", [&c, seen, coarse] { c.renderer.draw(c.ddoc, seen, coarse); },
                  [&c, seen, coarse] { rasterize(c.ddoc, seen, displacedPart(c.ddoc, c.mesh), coarse); }});
  return rows;
}

/// What one stage of the whole way leaves for the next, on either side.
struct Way {
  Way(GlContext& context, const Case& c)
      : slicer(context), observer(context), glVolume(context, c.profile), volume(c.profile) {}

  ReferenceImage glImage;
  ReferenceImage image;
  Mesh glMesh;
  Mesh mesh;
  GlSlicer slicer;
  GlObserver observer;
  std::unique_ptr<GlMesh> uploaded;
  GlVolume glVolume;
  Volume volume;
};

/// From a scene that is uploaded to light that reaches an eye: a DDOC, its image's mesh, the volume of it, and a frame.
std::vector<Row> wayRows(GlContext& context, const Case& c, Way& way, const BenchChoice& choice) {
  const ObserverOptions view{.width = choice.width, .height = choice.height};
  std::vector<Row> rows{
      {"way: construct ddoc", [&] { way.glImage = buildDdocImage(c.pinhole, c.mesh, {}, {}, &c.renderer); },
       [&] { way.image = buildDdocImage(c.pinhole, c.mesh, {}, {}); }},
      {"way: mesh", [&] { way.glMesh = imageMesh(way.glImage); }, [&] { way.mesh = imageMesh(way.image); }},
      {"way: upload the mesh", [&] { way.uploaded = std::make_unique<GlMesh>(context, way.glMesh); }, [] {}},
      {"way: slice", [&] { way.slicer.slice(*way.uploaded, way.glVolume); },
       [&] { way.volume = sliceExactly(way.mesh, c.profile); }},
      {"way: list lit voxels", [&] { way.observer.look(way.glVolume); }, [] {}},
      {"way: observe", [&, view] { way.observer.draw({.view = view}); },
       [&, view] { collectLight(way.volume, view); }}};
  const std::vector<Row> stages = rows;
  rows.push_back({"the whole way",
                  [stages] {
                    for (const Row& stage : stages) {
                      stage.onGpu();
                    }
                  },
                  [stages] {
                    for (const Row& stage : stages) {
                      stage.onCpu();
                    }
                  }});
  return rows;
}

/// Runs all in turn, and prints the best times.
void measure(GlContext& context, std::vector<Row> rows, const Case& c, int runs, nlohmann::ordered_json& results) {
  for (int run = 0; run <= runs; ++run) {  // the first is not counted
    for (Row& row : rows) {
      const double gpuMs = milliseconds([&] {
        row.onGpu();
        context.gl().Finish();
      });
      const double processorMs = row.onCpu ? milliseconds(row.onCpu) : 0;
      if (run > 0) {
        row.gpuMs = std::min(row.gpuMs, gpuMs);
        row.processorMs = std::min(row.processorMs, processorMs);
      }
    }
  }
  for (const Row& row : rows) {
    const bool compared = row.processorMs > 0.001;  // there may be nothing to do
    fmt::print("{:>10} {:<28} {:>9.1f} {:>9} {:>9}\n", c.mesh.triangles.size(), row.what, row.gpuMs,
               compared ? fmt::format("{:.1f}", row.processorMs) : "",
               compared ? fmt::format("{:.2f}", row.gpuMs / row.processorMs) : "");
    nlohmann::ordered_json result{{"triangles", c.mesh.triangles.size()}, {"what", row.what}, {"glMs", row.gpuMs}};
    if (compared) {
      result["processorMs"] = row.processorMs;
    }
    results.push_back(result);
  }
  std::fflush(stdout);
}

void measureScenes(const BenchChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const GlScope scope(*context);
  const GlInfo& info = context->info();
  fmt::print("{} through {}, {}: {}\n{}x{}, display \"{}\", {} threads, best of {} runs\n\n", info.renderer,
             nameOf(info.provider), info.isSoftware ? "a software renderer" : "a GPU", info.version, choice.width,
             choice.height, choice.profile, threadCount(), choice.runs);
  fmt::print("{:>10} {:<28} {:>9} {:>9} {:>9}\n", "triangles", "", "OpenGL ms", "CPU ms", "ratio");
  nlohmann::ordered_json report{{"renderer", info.renderer},     {"provider", nameOf(info.provider)},
                                {"isSoftware", info.isSoftware}, {"version", info.version},
                                {"width", choice.width},         {"height", choice.height},
                                {"profile", choice.profile},     {"threads", threadCount()},
                                {"runs", choice.runs},           {"results", nlohmann::ordered_json::array()}};
  for (const size_t triangles : choice.triangles) {
    const Case c(*context, fmt::format(fmt::runtime(choice.scene), triangles), choice);
    measure(*context, imageRows(*context, c), c, choice.runs, report["results"]);
    measure(*context, constructionRows(c), c, choice.runs, report["results"]);
    Way way(*context, c);
    measure(*context, wayRows(*context, c, way, choice), c, choice.runs, report["results"]);
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, report.dump(2) + "\n");
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Images, constructions and the way from a scene to a volume, with OpenGL and without.",
                   "gl_render_bench");
  BenchChoice choice;
  program.add_option("--scene", choice.scene, "Scene, with {} for the triangle count")->capture_default_str();
  program.add_option("--triangles", choice.triangles, "Triangle counts")->delimiter(',')->capture_default_str();
  program.add_option("--provider", choice.provider, "auto, egl or osmesa")->capture_default_str();
  program.add_option("--profile", choice.profile, "Display")->capture_default_str();
  addCommonOptions(program, choice);
  program.add_option("--json", choice.json, "Write the same figures to a file");
  return runProgram(program, argumentCount, arguments, choice, measureScenes);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
