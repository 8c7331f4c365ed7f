// Reference images that ranks of an MPI job draw together: what drawing, waiting and compositing take, and what is
// sent. Run it with mpirun; docs/many_machines.md quotes its figures, and scripts/measure_ranks.sh takes them.
//
// All ranks construct the same image again and again, each on --threads threads. A time is wall time of the slowest
// rank, of the fastest of --runs constructions; the parts of the slowest rank are those of the same construction.
// Making the share of the scene (its triangles with their vertices) is done once, before. One line of JSON for each
// camera.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/compositing/shared_renderer.h"
#include "oc_core/mpi/mpi_ranks.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/ranks/mpi_launch.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct RanksChoice {
  std::string scene = "builtin:statues,triangles=1000000";
  std::vector<std::string> cameras{"di", "ddoc", "eoc-h"};
  std::string compositing = "direct";
  int runs = 5;
  int threads = 1;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
};

/// Microseconds of the slowest rank.
uint64_t ofSlowest(Ranks& ranks, double milliseconds) {
  return ranks.largest(static_cast<uint64_t>(milliseconds * 1000));
}

uint64_t ofFastest(Ranks& ranks, double milliseconds) {
  return ~ranks.largest(~static_cast<uint64_t>(milliseconds * 1000));
}

struct Figures {
  uint64_t total = ~uint64_t{0};  ///< microseconds, here and below
  uint64_t drawing = 0;
  uint64_t drawingFastest = 0;  ///< of the rank that drew fastest
  uint64_t merging = 0;
  uint64_t sentMax = 0;  ///< bytes, by the rank that sends most
  uint64_t images = 0;
};

Figures measureCamera(const RanksChoice& choice, const std::string& name, const Mesh& mesh,
                      const SharedRenderer& renderer, Ranks& ranks) {
  const CameraChoice camera = cameraChoice(name);
  Figures best;
  for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
    // From another eye each time: nothing is left of the last one.
    const PinholeCamera reference(movedEye(View{}, glm::vec3(1e-4f * static_cast<float>(run))), choice.width,
                                  choice.height);
    ranks.largest(0);  // all begin together
    const SharedDrawing before = renderer.cost();
    const uint64_t sentBefore = ranks.bytesSent();
    const double taken = milliseconds([&] {
      if (ranks.size() == 1) {
        buildReferenceImages(camera, reference, mesh);
      } else {
        buildReferenceImages(camera, reference, mesh, {}, renderer);
      }
    });
    const uint64_t sent = ranks.bytesSent() - sentBefore;
    const SharedDrawing after = renderer.cost();
    const double drawing = 1000 * (after.drawSeconds - before.drawSeconds);
    const Figures figures{
        ofSlowest(ranks, taken),   ofSlowest(ranks, drawing),
        ofFastest(ranks, drawing), ofSlowest(ranks, 1000 * (after.mergeSeconds - before.mergeSeconds)),
        ranks.largest(sent),       static_cast<uint64_t>(after.images - before.images)};
    if (run > 0 && figures.total < best.total) {
      best = figures;
    }
  }
  return best;
}

void measureRanks(const RanksChoice& choice) {
  if (!mpiLaunch()) {
    throw InputError("this measures ranks of an MPI job", "ranks_bench", "mpirun -n 2 ranks_bench");
  }
  const std::unique_ptr<Ranks> ranks = mpiRanks();
  const Mesh mesh = loadScene(choice.scene, {});
  std::unique_ptr<SharedRenderer> renderer;
  const uint64_t sharing = ofSlowest(*ranks, milliseconds([&] {
    renderer = std::make_unique<SharedRenderer>(mesh, *ranks, compositingFromText(choice.compositing, "--compositing"));
  }));
  for (const std::string& camera : choice.cameras) {
    const Figures figures = measureCamera(choice, camera, mesh, *renderer, *ranks);
    if (ranks->isFirst()) {
      const nlohmann::ordered_json json = {{"camera", camera},
                                           {"ranks", ranks->size()},
                                           {"threads", choice.threads},
                                           {"compositing", choice.compositing},
                                           {"triangles", mesh.triangles.size()},
                                           {"share_us", sharing},
                                           {"total_us", figures.total},
                                           {"draw_us", figures.drawing},
                                           {"draw_fastest_us", figures.drawingFastest},
                                           {"composite_us", figures.merging},
                                           {"images", figures.images},
                                           {"sent_bytes", figures.sentMax}};
      fmt::print("{}\n", json.dump());
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  using namespace ocelli;
  CLI::App program("Reference images that ranks draw together", "ranks_bench");
  RanksChoice choice;
  program.add_option("--scene", choice.scene, "A scene")->capture_default_str();
  program.add_option("--cameras", choice.cameras, "Cameras")->delimiter(',')->capture_default_str();
  program.add_option("--compositing", choice.compositing, "direct or swap")->capture_default_str();
  addCommonOptions(program, choice);
  return runProgram(program, argumentCount, arguments, choice, measureRanks);
}
