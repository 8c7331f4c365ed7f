// Slicing and observing with OpenGL against the same on the CPU, in one run. Counters: triangles, lit voxels, the
// times of this way and the CPU's in ms, best of all runs (ms, cpu_ms), one relative to the other (x_cpu), and
// voxels whose bits differ (differing).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "bench/timing.h"
#include "display_sim/gl/gl_observer.h"
#include "display_sim/gl/gl_slicer.h"
#include "display_sim/observing/observer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

/// What is sliced: `ocri` stands for the mesh of a DDOC's reference image of the scene, which has about 600 K
/// triangles.
struct Source {
  const char* name;
  std::string scene;
  bool ocri = false;
};

Mesh meshOf(const Source& source) {
  Mesh scene = loadScene(source.scene);
  const PinholeCamera camera{View{}, kDefaultWidth, kDefaultHeight};
  return source.ocri ? imageMesh(buildDdocImage(camera, scene, DdocOptions{})) : scene;
}

/// One mesh on the CPU and on the GPU, and its volume on both.
struct Case {
  Case(GlContext& context, const Source& source)
      : mesh(meshOf(source)),
        volume(sliceExactly(mesh, profile)),
        lit(volume.litVoxels()),
        glMesh(context, mesh),
        glVolume(context, volume) {}

  DisplayProfile profile = loadProfile("perspecta");
  Mesh mesh;
  Volume volume;
  size_t lit;
  GlMesh glMesh;
  GlVolume glVolume;
};

/// What benchmarks of one run have in common.
class Session {
 public:
  explicit Session(GlContext& context)
      : context_(context),
        scope_(context),
        slicer_(context),
        singleSlicer_(context, GlPrecision::kSingle),
        observer_(context) {}

  void sliceOnGpu(benchmark::State& state, const Source& source, GlPrecision precision) {
    Case& c = caseOf(source);
    GlSlicer& slicer = precision == GlPrecision::kDouble ? slicer_ : singleSlicer_;
    compare(
        state, c, [&] { slicer.slice(c.glMesh, c.glVolume); }, [&] { c.volume = sliceExactly(c.mesh, c.profile); });
    const Volume sliced = c.glVolume.read();
    size_t differing = 0;
    for (int i = 0; i < sliced.slices(); ++i) {
      forEachLit(sliced, i, [&](int column, int row, unsigned bits) {
        differing += c.volume.colorBits(i, column, row) != bits ? 1 : 0;
      });
      forEachLit(c.volume, i,
                 [&](int column, int row, unsigned) { differing += sliced.colorBits(i, column, row) == 0 ? 1 : 0; });
    }
    state.counters["differing"] = static_cast<double>(differing);
  }

  /// The whole way from a mesh in the memory of the CPU to a volume there.
  void sliceThroughGpu(benchmark::State& state, const Source& source) {
    Case& c = caseOf(source);
    compare(
        state, c,
        [&] {
          slicer_.slice(GlMesh(context_, c.mesh), c.glVolume);
          benchmark::DoNotOptimize(c.glVolume.read());
        },
        [&] { c.volume = sliceExactly(c.mesh, c.profile); });
  }

  /// A frame of a display whose volume stays.
  void observeOnGpu(benchmark::State& state, const Source& source, int width, int height, GlSplat splat) {
    Case& c = caseOf(source);
    const ObserverOptions view{.width = width, .height = height};
    observer_.look(c.glVolume);
    compare(
        state, c, [&] { observer_.draw({.view = view, .splat = splat}); },
        [&] { benchmark::DoNotOptimize(collectLight(c.volume, view)); });
    state.counters["frames_per_s"] = 1000 / state.counters["ms"];
  }

  /// What a new volume adds to that.
  void lookOnGpu(benchmark::State& state, const Source& source) {
    Case& c = caseOf(source);
    compare(
        state, c, [&] { observer_.look(c.glVolume); }, [&] { benchmark::DoNotOptimize(c.volume.litVoxels()); });
  }

 private:
  static constexpr int kMaxTurns = 10;

  void compare(benchmark::State& state, const Case& c, const std::function<void()>& onGpu,
               const std::function<void()>& onCpu) {
    const auto finished = [&] {
      onGpu();
      context_.gl().Finish();
    };
    finished();  // warm
    onCpu();
    double best = 1e30;
    double bestOnCpu = 1e30;
    int turns = 0;
    for (auto _ : state) {
      const double ms = milliseconds(finished);
      best = std::min(best, ms);
      state.SetIterationTime(ms / 1000);
      // They take turns, so that what else the machine does hits both alike.
      if (turns++ < kMaxTurns) {
        bestOnCpu = std::min(bestOnCpu, milliseconds(onCpu));
      }
    }
    state.counters["ms"] = best;
    state.counters["triangles"] = static_cast<double>(c.mesh.triangles.size());
    state.counters["lit"] = static_cast<double>(c.lit);
    state.counters["cpu_ms"] = bestOnCpu;
    state.counters["x_cpu"] = best / bestOnCpu;
  }

  /// One at a time is in memory.
  Case& caseOf(const Source& source) {
    if (name_ != source.name) {
      case_.reset();
      case_ = std::make_unique<Case>(context_, source);
      name_ = source.name;
    }
    return *case_;
  }

  GlContext& context_;
  GlScope scope_;
  GlSlicer slicer_;
  GlSlicer singleSlicer_;
  GlObserver observer_;
  std::string name_;
  std::unique_ptr<Case> case_;
};

void registerAll(Session& session) {
  static const std::vector<Source> sources = [] {
    std::vector<Source> all;
    if (const char* folder = std::getenv("OCELLI_DATA_DIR")) {
      all.push_back({"bunny", std::string(folder) + "/bunny.obj"});
    }
    all.push_back({"ocri", "builtin:statues,triangles=1000000", true});
    all.push_back({"600K", "builtin:statues,triangles=600000"});
    all.push_back({"4.6M", "builtin:statues,triangles=4600000"});
    return all;
  }();
  for (const Source& source : sources) {
    const auto add = [&](const char* name, const std::function<void(benchmark::State&)>& run) {
      benchmark::RegisterBenchmark((std::string(name) + "/" + source.name).c_str(), run)
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
    };
    using State = benchmark::State;
    add("slice", [&](State& state) { session.sliceOnGpu(state, source, GlPrecision::kDouble); });
    add("slice_single", [&](State& state) { session.sliceOnGpu(state, source, GlPrecision::kSingle); });
    add("slice_with_transfers", [&](State& state) { session.sliceThroughGpu(state, source); });
    add("look", [&](State& state) { session.lookOnGpu(state, source); });
    for (const auto& [name, splat] : {std::pair("boxes", GlSplat::kBoxes), std::pair("points", GlSplat::kPoints)}) {
      for (const auto& [width, height] : {std::pair(720, 480), std::pair(768, 768)}) {
        const std::string full = std::string("observe_") + name + "_" + std::to_string(height);
        add(full.c_str(), [&session, &source, width = width, height = height, splat = splat](State& state) {
          session.observeOnGpu(state, source, width, height, splat);
        });
      }
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  const auto context = ocelli::openOffscreenContext();
  benchmark::AddCustomContext("opengl", context->info().renderer);
  ocelli::Session session(*context);
  ocelli::registerAll(session);
  benchmark::Initialize(&argumentCount, arguments);
  if (benchmark::ReportUnrecognizedArguments(argumentCount, arguments)) {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
