// How the construction of reference images grows with a packed scene: whole constructions from a pack, the choice of
// the clusters that the view needs and their mesh included, for every camera that has images; packs take turns. The
// last columns are the time of the last pack over that of the first, on the clock and of the CPU. With --full also the
// construction from all triangles of the last pack's scene. Prints a table in Markdown; every time is the least of
// --runs runs, after one that is not counted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/ocri/packed_view.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

struct Choice {
  std::vector<std::string> packs;
  std::string full;  ///< the scene of the last one, not packed; empty: none
  std::vector<std::string> cameras;
  float pixels = kPackedErrorPixels;
  int runs = 5;
  int threads = 0;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
};

std::vector<std::string> allCameras() {
  std::vector<std::string> names;
  for (const RepresentationKind& kind : representationKinds()) {
    if (kind.images) {
      names.emplace_back(kind.name);
    }
  }
  return names;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The least times so far of one camera over one pack.
struct Least {
  double mesh = kNever;  ///< from the pack to the mesh of its clusters
  double all = kNever;   ///< from the pack to the images
  double cpu = kNever;   ///< the same, of all threads together
  size_t triangles = 0;  ///< of that mesh
};

void measureOnce(const CameraChoice& choice, const PinholeCamera& camera, const PackedScene& scene, float pixels,
                 Least& least) {
  Mesh mesh;
  double meshed = 0;
  double all = 0;
  const double cpu = processorMilliseconds([&] {
    all = milliseconds([&] {
      meshed = milliseconds([&] {
        requireViewpointsOutside(scene, choice, camera);
        mesh = meshForView(scene, choice, camera, pixels);
      });
      buildReferenceImages(choice, camera, mesh);
    });
  });
  least.cpu = std::min(least.cpu, cpu);
  least.mesh = std::min(least.mesh, meshed);
  least.all = std::min(least.all, all);
  least.triangles = mesh.triangles.size();
}

void measure(const Choice& choice) {
  std::vector<std::unique_ptr<PackedScene>> packs;
  std::string head = "| camera |";
  std::string line = "| --- |";
  for (const std::string& path : choice.packs) {
    packs.push_back(std::make_unique<PackedScene>(path));
    const double millions = static_cast<double>(packs.back()->triangleCount()) / 1e6;
    head += fmt::format(" {:.1f} M: triangles looked at | their mesh | all |", millions);
    line += " ---: | ---: | ---: |";
  }
  Mesh full;
  if (!choice.full.empty()) {
    full = loadScene(choice.full);
    head += " from all triangles |";
    line += " ---: |";
  }
  fmt::print("{} threads, {}x{}, surfaces at most {} pixels off, least of {} runs, milliseconds\n\n", threadCount(),
             choice.width, choice.height, choice.pixels, choice.runs);
  fmt::print("{} ratio | of CPU time |\n{} ---: | ---: |\n", head, line);
  const PinholeCamera camera(View{}, choice.width, choice.height);
  for (const std::string& name : choice.cameras.empty() ? allCameras() : choice.cameras) {
    const CameraChoice chosen = cameraChoice(name);
    std::vector<Least> least(packs.size());
    for (int run = 0; run <= choice.runs; ++run) {
      for (size_t i = 0; i < packs.size(); ++i) {
        Least ignored;
        measureOnce(chosen, camera, *packs[i], choice.pixels, run == 0 ? ignored : least[i]);
      }
    }
    std::string row = fmt::format("| `{}` |", name);
    for (const Least& one : least) {
      row += fmt::format(" {:.0f} K | {:.1f} | {:.1f} |", static_cast<double>(one.triangles) / 1e3, one.mesh, one.all);
    }
    if (!full.empty()) {
      double all = kNever;
      for (int run = 0; run < choice.runs; ++run) {
        all = std::min(all, milliseconds([&] { buildReferenceImages(chosen, camera, full); }));
      }
      row += fmt::format(" {:.1f} |", all);
    }
    fmt::print("{} {:.2f} | {:.2f} |\n", row, least.back().all / least.front().all,
               least.back().cpu / least.front().cpu);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Constructions from packed scenes", "pack_bench");
  program.add_option("PACKS", choice.packs, "Packed scenes, the smallest first")->required();
  program.add_option("--full", choice.full, "The scene of the last pack, not packed: the baseline");
  program.add_option("--cameras", choice.cameras, "Which; all that have images where left out")->delimiter(',');
  program.add_option("--pixels", choice.pixels, "How far surfaces may be off")->capture_default_str();
  ocelli::addCommonOptions(program, choice);
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
