// What a packed scene saves: whole constructions of reference images from the clusters that a view needs, beside the
// same from all triangles, in turns, and how the two differ.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/view_cut.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

struct Choice {
  std::string pack;
  std::string full;  ///< the same scene, not packed; empty: none
  std::vector<std::string> cameras{"di", "eoc-h", "eoc-hv", "spoc", "ddoc"};
  float pixels = 0.5f;
  int runs = 5;
  int threads = 0;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
};

double best(int runs, const std::function<void()>& work) {
  double least = 1e30;
  for (int i = 0; i < runs; ++i) {
    least = std::min(least, milliseconds(work));
  }
  return least;
}

void measure(const Choice& choice) {
  const PackedScene scene(choice.pack);
  Mesh full;
  if (!choice.full.empty()) {
    full = loadScene(choice.full);
  }
  View view;
  const PinholeCamera camera(view, choice.width, choice.height);
  const ViewCutOptions options{.maxErrorPixels = choice.pixels, .marginPixels = 64, .reach = 1.4f};
  std::vector<ClusterChoice> cut;
  Mesh mesh;
  fmt::print("first cut {:.1f} ms\n", milliseconds([&] { cut = viewCut(scene, camera, options); }));
  fmt::print("first mesh {:.1f} ms\n", milliseconds([&] { mesh = meshOf(scene, cut); }));
  fmt::print("cut {:.2f} ms, {} clusters\n", best(choice.runs, [&] { cut = viewCut(scene, camera, options); }),
             cut.size());
  fmt::print("mesh {:.2f} ms, {} triangles, {} vertices\n", best(choice.runs, [&] { mesh = meshOf(scene, cut); }),
             mesh.triangles.size(), mesh.positions.size());
  for (const std::string& name : choice.cameras) {
    const CameraChoice chosen = cameraChoice(name);
    ReferenceImages images;
    const double packed = best(choice.runs, [&] { images = buildReferenceImages(chosen, camera, mesh); });
    Mesh ocri;
    const double meshed = best(choice.runs, [&] { ocri = unionMesh(images); });
    fmt::print("{:8} packed {:.1f} ms, mesh {:.1f} ms, {} triangles", name, packed, meshed, ocri.triangles.size());
    if (!full.empty()) {
      fmt::print(", all {:.1f} ms", best(choice.runs, [&] { images = buildReferenceImages(chosen, camera, full); }));
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Constructions from a packed scene", "pack_bench");
  program.add_option("PACK", choice.pack, "A packed scene")->required();
  program.add_option("--full", choice.full, "The same scene, not packed: the baseline");
  program.add_option("--cameras", choice.cameras, "Which")->delimiter(',');
  program.add_option("--pixels", choice.pixels, "How far surfaces may be off")->capture_default_str();
  ocelli::addCommonOptions(program, choice);
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
