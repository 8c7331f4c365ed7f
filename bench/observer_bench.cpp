// What an observer of a volume on the reference display sees, 720x480. Counters: lit voxels, exposed arcs. The file
// bunny.obj is taken from the folder that OCELLI_DATA_DIR names; without it, there is the teapot only.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "display_sim/observing/observer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr ObserverOptions kView{.width = 720, .height = 480};

void observeVolume(benchmark::State& state, const Volume& volume, const ObserverOptions& options) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(collectLight(volume, options));
  }
  state.counters["lit"] = static_cast<double>(volume.litVoxels());
  state.counters["arcs"] = static_cast<double>(
      exposedArcs(volume.profile(), exposedSweep(options, volume.profile()), options.wobble).size());
}

struct NamedView {
  std::string name;
  ObserverOptions options;
};

std::vector<NamedView> views() {
  std::vector<NamedView> views(6, {"even", kView});
  for (size_t i = 1; i < views.size(); ++i) {
    views[i].options.emission.model = EmissionModel::kScreen;
  }
  views[1].name = "screen";
  views[2].name = "wobble_over_a_turn";
  views[2].options.exposureSeconds = 1.0 / 12;
  views[2].options.wobble.amplitudeRadii = 0.005 / 0.127;
  views[3].name = "pupil_of_4_mm";
  views[3].options.lens.apertureRadii = 0.004 / 0.127;
  views[4].name = "lens_of_18_mm";
  views[4].options.lens.apertureRadii = 0.018 / 0.127;
  views[5].name = "ambient";
  views[5].options.ambient = 0.002;
  return views;
}

void registerAll() {
  std::vector<std::string> scenes = {"builtin:teapot"};
  if (std::getenv("OCELLI_DATA_DIR") != nullptr) {
    scenes.insert(scenes.end(), {"builtin:room,mesh=bunny.obj", "builtin:statues,mesh=bunny.obj"});
  }
  for (const std::string& scene : scenes) {
    const auto volume = std::make_shared<Volume>(sliceExactly(loadScene(scene), loadProfile("perspecta")));
    for (const NamedView& view : views()) {
      benchmark::RegisterBenchmark((view.name + "/" + scene).c_str(),
                                   [=](benchmark::State& state) { observeVolume(state, *volume, view.options); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  benchmark::Initialize(&argumentCount, arguments);
  if (benchmark::ReportUnrecognizedArguments(argumentCount, arguments)) {
    return 1;
  }
  ocelli::registerAll();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
