// Construction of the DDOC with its image, without and with "do no harm" feedback, next to what it cannot do without:
// the depth image of the same scene. Scenes of 0.3, 1 and 4 million triangles, 720x480.
#include <benchmark/benchmark.h>

#include <map>

#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

const PinholeCamera& camera() {
  static const PinholeCamera pinhole(View{}, kDefaultWidth, kDefaultHeight);
  return pinhole;
}
const Mesh& sceneOf(int64_t triangles) {
  static std::map<int64_t, Mesh> scenes;
  Mesh& mesh = scenes[triangles];
  if (mesh.empty()) {
    mesh = loadScene("builtin:statues,triangles=" + std::to_string(triangles));
  }
  return mesh;
}

void depthImage(benchmark::State& state) {
  const Mesh& mesh = sceneOf(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(buildDepthImage(camera(), mesh));
  }
}
void ddocImage(benchmark::State& state, int feedbackRounds) {
  const Mesh& mesh = sceneOf(state.range(0));
  DdocOptions options;
  options.feedbackRounds = feedbackRounds;
  for (auto _ : state) {
    benchmark::DoNotOptimize(buildDdocImage(camera(), mesh, options));
  }
}
void ddocPlain(benchmark::State& state) {
  ddocImage(state, 0);
}
void ddocWithFeedback(benchmark::State& state) {
  ddocImage(state, DdocOptions{}.feedbackRounds);
}

void sizes(benchmark::internal::Benchmark* run) {
  run->Arg(300000)->Arg(1000000)->Arg(4000000)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}
BENCHMARK(depthImage)->Apply(sizes);
BENCHMARK(ddocPlain)->Apply(sizes);
BENCHMARK(ddocWithFeedback)->Apply(sizes);

}  // namespace
}  // namespace ocelli

BENCHMARK_MAIN();
