// Rasterisation against ray casting (Embree) of the same image, and the fast slicer against its exact reference.
#include <benchmark/benchmark.h>

#include "display_sim/frames/display_profile.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

const PinholeCamera& camera() {
  static const PinholeCamera pinhole(View{}, kDefaultWidth, kDefaultHeight);
  return pinhole;
}
const Mesh& scene() {
  static const Mesh mesh = loadScene("builtin:statues,triangles=1000000");
  return mesh;
}

void rasterizePinhole(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(rasterize(camera(), scene()));
  }
}
void raycastPinhole(benchmark::State& state) {
  const RayScene rays(scene());
  for (auto _ : state) {
    benchmark::DoNotOptimize(raycast(camera(), scene(), rays));
  }
}
void buildBvhOfRaycast(benchmark::State& state) {
  for (auto _ : state) {
    const RayScene rays(scene());
    benchmark::DoNotOptimize(&rays);
  }
}
void rasterizeDdoc(benchmark::State& state) {
  const DdocCamera ddoc = buildDdocCamera(camera(), scene());
  for (auto _ : state) {
    benchmark::DoNotOptimize(rasterize(ddoc, scene()));
  }
}
void constructDdoc(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(buildDdocCamera(camera(), scene()));
  }
}
void sliceFast(benchmark::State& state) {
  const DisplayProfile profile = loadProfile("test");
  for (auto _ : state) {
    benchmark::DoNotOptimize(sliceExactly(scene(), profile));
  }
}

BENCHMARK(rasterizePinhole)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(raycastPinhole)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(buildBvhOfRaycast)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rasterizeDdoc)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(constructDdoc)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sliceFast)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace ocelli

BENCHMARK_MAIN();
