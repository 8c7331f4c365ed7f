// Slicing and observing with OpenGL against the same on the processor, in one run. Counters: triangles, lit voxels, the
// time of the processor's way in ms (best of all runs), and this way's relative to it (x_cpu, best of all runs).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "bench/timing.h"
#include "display_sim/gl/gl_slicer.h"
#include "display_sim/slicer.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/scene/scene_source.h"

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

/// One mesh on the processor and on the GPU, and its volume on both.
struct Case {
  Case(GlContext& context, const Source& source)
      : mesh(meshOf(source)), volume(slice(mesh, profile)), glMesh(context, mesh), glVolume(context, volume) {}

  DisplayProfile profile = loadProfile("perspecta");
  Mesh mesh;
  Volume volume;
  GlMesh glMesh;
  GlVolume glVolume;
};

/// What benchmarks of one run have in common.
class Session {
 public:
  explicit Session(GlContext& context) : context_(context), scope_(context), slicer_(context) {}

  void sliceOnGpu(benchmark::State& state, const Source& source) {
    Case& c = caseOf(source);
    compare(
        state, c, [&] { slicer_.slice(c.glMesh, c.glVolume); }, [&] { c.volume = slice(c.mesh, c.profile); });
    state.counters["lit"] = static_cast<double>(c.glVolume.read().litVoxels());
  }

  /// The whole way from a mesh in the memory of the processor to a volume there.
  void sliceThroughGpu(benchmark::State& state, const Source& source) {
    Case& c = caseOf(source);
    compare(
        state, c,
        [&] {
          slicer_.slice(GlMesh(context_, c.mesh), c.glVolume);
          benchmark::DoNotOptimize(c.glVolume.read());
        },
        [&] { c.volume = slice(c.mesh, c.profile); });
  }

 private:
  static constexpr int kMostTurns = 10;

  void compare(benchmark::State& state, const Case& c, const std::function<void()>& onGpu,
               const std::function<void()>& onProcessor) {
    const auto finished = [&] {
      onGpu();
      context_.gl().Finish();
    };
    finished();  // warm
    onProcessor();
    double best = 1e30;
    double bestOnProcessor = 1e30;
    int turns = 0;
    for (auto _ : state) {
      const double ms = milliseconds(finished);
      best = std::min(best, ms);
      state.SetIterationTime(ms / 1000);
      // They take turns, so that what else the machine does hits both alike.
      if (turns++ < kMostTurns) {
        bestOnProcessor = std::min(bestOnProcessor, milliseconds(onProcessor));
      }
    }
    state.counters["triangles"] = static_cast<double>(c.mesh.triangles.size());
    state.counters["cpu_ms"] = bestOnProcessor;
    state.counters["x_cpu"] = best / bestOnProcessor;
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
    all.push_back({"1M", "builtin:statues,triangles=1000000"});
    all.push_back({"4.6M", "builtin:statues,triangles=4600000"});
    return all;
  }();
  for (const Source& source : sources) {
    const auto add = [&](const char* name, void (Session::*run)(benchmark::State&, const Source&)) {
      benchmark::RegisterBenchmark((std::string(name) + "/" + source.name).c_str(),
                                   [&session, &source, run](benchmark::State& state) { (session.*run)(state, source); })
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
    };
    add("slice", &Session::sliceOnGpu);
    add("slice_with_transfers", &Session::sliceThroughGpu);
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
