// Table 3.5 of the dissertation, measured again: how long it takes to turn a scene into the slices of the display, from
// its geometry, from its depth image (DI) and from its occlusion camera reference image (OCRI).
//
// The construction of DI and OCRI is given by itself, and the speedup over geometry both without and with it. The peer
// in the same run is meshoptimizer: the scene decimated once to as many triangles as the OCRI has, its time taken as
// construction. Times are medians of --runs runs, after one run that is not counted; the slicer keeps its memory.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/timing.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

/// A row of the published table; seconds, thousands of triangles.
struct Published {
  double imageTriangles, depthSeconds, constructionSeconds, ocriSeconds, geometryTriangles, geometrySeconds;
};

struct Case {
  const char* name;
  const char* scene;
  int width, height;
  Published published;
};

constexpr Case kCases[] = {
    {"Bunny", "builtin:room,mesh=bunny.obj", 720, 480, {612, 12.0, 2.73, 11.8, 321, 8.02}},
    {"Bunny QR", "builtin:room,mesh=bunny.obj", 180, 120, {37.8, 0.766, 0.875, 0.75, 321, 7.81}},
    {"Buddha statues",
     "builtin:statues,mesh=buddha.obj,triangles=4603000",
     720,
     480,
     {612, 11.4, 12.1, 11.5, 4603, 131}},
    {"10 M stand-in", "builtin:room,mesh=dragon.obj,triangles=10252000", 720, 480, {612, 12.5, 20.3, 13.9, 10252, 292}},
};

void measure(const Case& row, int runs, const DisplayProfile& profile) {
  const Mesh scene = loadScene(row.scene);
  const PinholeCamera camera(View{}, row.width, row.height);
  Slicer slicer(profile);
  const auto sliceTime = [&](const Mesh& mesh) {
    return medianMilliseconds(runs, [&] { slicer.slice(SliceMesh(mesh)); });
  };

  Mesh depthMesh;
  const double depthBuild = medianMilliseconds(runs, [&] { depthMesh = imageMesh(buildDepthImage(camera, scene)); });
  Mesh ocriMesh;
  const double ocriBuild =
      medianMilliseconds(runs, [&] { ocriMesh = imageMesh(buildDdocImage(buildDdocCamera(camera, scene), scene)); });
  const double geometrySlice = sliceTime(scene);

  const auto print = [&](const char* what, const Mesh& mesh, double build, double sliceMs, double textTriangles,
                         double textBuild, double textSlice) {
    fmt::print("{:<15} {:<12} {:>10.1f} {:>10.1f} {:>10.1f} {:>9.2f} {:>9.2f}", row.name, what,
               static_cast<double>(mesh.triangles.size()) / 1000, build, sliceMs, geometrySlice / sliceMs,
               geometrySlice / (build + sliceMs));
    if (textSlice > 0) {
      fmt::print("   {:>10.1f} {:>10.2f} {:>10.2f} {:>9.2f} {:>9.2f}", textTriangles, textBuild, textSlice,
                 row.published.geometrySeconds / textSlice, row.published.geometrySeconds / (textBuild + textSlice));
    }
    fmt::print("\n");
    std::fflush(stdout);
  };
  const Published& text = row.published;
  print("geometry", scene, 0, geometrySlice, text.geometryTriangles, 0, text.geometrySeconds);
  print("DI", depthMesh, depthBuild, sliceTime(depthMesh), text.imageTriangles, 0, text.depthSeconds);
  print("OCRI (DDOC)", ocriMesh, ocriBuild, sliceTime(ocriMesh), text.imageTriangles, text.constructionSeconds,
        text.ocriSeconds);
  if (ocriMesh.triangles.size() < scene.triangles.size()) {
    Mesh simpleMesh;
    const double simpleBuild = medianMilliseconds(
        1, [&] { simpleMesh = simplifyMesh(scene, ocriMesh.triangles.size(), SimplifyMethod::kTopological).mesh; });
    print("decimated", simpleMesh, simpleBuild, sliceTime(simpleMesh), 0, 0, 0);
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Table 3.5: time to slice geometry, depth image and OCRI. Needs OCELLI_DATA_DIR.");
  int runs = 5;
  int threads = 0;
  std::string profile = "perspecta";
  program.add_option("--runs", runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", threads, "0 stands for all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  program.add_option("--profile", profile, "Display profile")->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);
  setThreadCount(threads);
  try {
    const DisplayProfile display = loadProfile(profile);
    fmt::print("{} threads, display {}, medians of {} runs\n\n", threadCount(), profile, runs);
    fmt::print("{:<15} {:<12} {:^52}   {:^52}\n", "", "", "measured here", "dissertation, Table 3.5");
    fmt::print("{:<15} {:<12} {:>10} {:>10} {:>10} {:>9} {:>9}   {:>10} {:>10} {:>10} {:>9} {:>9}\n", "scene", "sliced",
               "triangles", "build", "slice", "speedup", "with", "triangles", "build", "slice", "speedup", "with");
    fmt::print("{:<15} {:<12} {:>10} {:>10} {:>10} {:>9} {:>9}   {:>10} {:>10} {:>10} {:>9} {:>9}\n", "", "", "x1000",
               "ms", "ms", "", "build", "x1000", "s", "s", "", "build");
    for (const Case& row : kCases) {
      measure(row, runs, display);
    }
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "table_3_5: error: {}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
