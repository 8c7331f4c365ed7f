// How long it takes to construct what a user may choose from, in one run: images of several cameras, and the peers,
// which are meshoptimizer's simplification of the scene to as many triangles as the OCRI has and OpenGL (llvmpipe)
// drawing the depth image. Counters: the time relative to our own depth image (x_di) and to llvmpipe's (x_gl), best of
// all runs, and the triangles or samples that come out.
//
// To add a row, add a line to rows().
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

#include "bench/timing.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/cell_builder.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/worlds/scene_source.h"
#ifdef OCELLI_BENCH_OSMESA
#include "bench/osmesa_renderer.h"
#endif

namespace ocelli {
namespace {

struct Case {
  Mesh scene;
  PinholeCamera camera{View{}, kDefaultWidth, kDefaultHeight};
  size_t ocriTriangles = 0;

  explicit Case(const std::string& source)
      : scene(loadScene(source)), ocriTriangles(imageMesh(buildDepthImage(camera, scene)).triangles.size()) {}
};

/// What a row makes once, outside of the time, and then again and again. The latter returns how many samples or
/// triangles there are.
using Work = std::function<size_t()>;

struct Row {
  const char* name;
  std::function<Work(const Case&)> prepare;
};

size_t samplesOf(const ReferenceImages& images) {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return samples;
}

Row imagesRow(const char* name, const std::function<ReferenceImages(const Case&)>& build) {
  return {name, [build](const Case& c) -> Work { return [build, &c] { return samplesOf(build(c)); }; }};
}

Row simplifyRow(const char* name, SimplifyMethod method) {
  return {name, [method](const Case& c) -> Work {
            return [method, &c] { return simplifyMesh(c.scene, c.ocriTriangles, method).mesh.triangles.size(); };
          }};
}

ReferenceImages ddoc(const Case& c, int feedbackRounds) {
  DdocOptions options;
  options.feedbackRounds = feedbackRounds;
  return {buildDdocImage(c.camera, c.scene, options)};
}

#ifdef OCELLI_BENCH_OSMESA
Work drawWithOpenGl(const Case& c) {
  const auto renderer = std::make_shared<OsMesaRenderer>(c.camera, c.scene);
  renderer->drawFrame();
  // It only counts as a peer if it draws the same: all but silhouettes, to the precision of its depth buffer.
  const Image<float> depths = renderer->depths();
  const ReferenceImage image = buildDepthImage(c.camera, c.scene);
  size_t same = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    same += std::abs(depths[i] - image.t[i]) < 0.01f;
  }
  if (same < depths.size() / 100 * 98) {
    throw WorkError("OpenGL draws another image", renderer->name(), "check the matrices of osmesa_renderer.cpp");
  }
  return [renderer] {
    renderer->drawFrame();
    return size_t{0};
  };
}
#endif

const char* const kDepthImage = "di";
const char* const kOpenGl = "peer_gl_depth_image";

ReferenceImages eoc(const Case& c, const glm::vec3& direction) {
  return {buildEocImage(c.camera, segmentAround(c.camera.view(), direction, ViewCell{}.sideRadii), c.scene)};
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      imagesRow(kDepthImage, [](const Case& c) { return ReferenceImages{buildDepthImage(c.camera, c.scene)}; }),
      imagesRow("ddoc_plain", [](const Case& c) { return ddoc(c, 0); }),
      imagesRow("ddoc", [](const Case& c) { return ddoc(c, DdocOptions{}.feedbackRounds); }),
      imagesRow("eoc_h", [](const Case& c) { return eoc(c, kHorizontalSegment); }),
      imagesRow("eoc_v", [](const Case& c) { return eoc(c, kVerticalSegment); }),
      imagesRow(
          "cell",
          [](const Case& c) { return ReferenceImages{buildCellImage(buildCellCamera(c.camera, c.scene), c.scene)}; }),
      imagesRow("ldi_4", [](const Case& c) { return buildLayeredDepthImage(c.camera, c.scene, 4); }),
      imagesRow("corners_8", [](const Case& c) { return buildCornerDepthImages(c.camera, c.scene, ViewCell{}, 8); }),
      simplifyRow("peer_simplify", SimplifyMethod::kTopological),
      simplifyRow("peer_simplify_sloppy", SimplifyMethod::kSloppy),
#ifdef OCELLI_BENCH_OSMESA
      {kOpenGl, drawWithOpenGl},
#endif
  };
  return all;
}

/// What benchmarks of one run have in common.
class Session {
 public:
  void construct(benchmark::State& state, const std::string& source, const Row& row) {
    const Work& work = workOf(source, row.name);
    size_t made = work();  // warm
    double best = 1e30;
    // The references take turns with the work, so that what else the machine does hits all alike.
    std::map<std::string, double> references;
    int turns = 0;
    for (auto _ : state) {
      const double ms = milliseconds([&] { made = work(); });
      best = std::min(best, ms);
      state.SetIterationTime(ms / 1000);
      if (turns++ < kMaxTurns) {
        timeReferences(source, references);
      }
    }
    if (made > 0) {
      state.counters["made"] = static_cast<double>(made);
    }
    for (const auto& [counter, reference] : references) {
      state.counters[counter] = best / reference;
    }
  }

 private:
  static constexpr int kMaxTurns = 10;

  void timeReferences(const std::string& source, std::map<std::string, double>& best) {
    for (const auto& [counter, name] : {std::pair("x_di", kDepthImage), std::pair("x_gl", kOpenGl)}) {
      if (const Work& work = workOf(source, name)) {
        const double ms = milliseconds(work);
        best[counter] = best.contains(counter) ? std::min(best[counter], ms) : ms;
      }
    }
  }

  /// Empty where there is no such row. One scene at a time is in memory.
  const Work& workOf(const std::string& source, const std::string& name) {
    if (source != source_) {
      source_ = source;
      works_.clear();
      case_.reset();
      case_ = std::make_unique<Case>(source);
    }
    if (!works_.contains(name)) {
      const auto row = std::find_if(rows().begin(), rows().end(), [&](const Row& r) { return r.name == name; });
      works_[name] = row != rows().end() ? row->prepare(*case_) : Work();
    }
    return works_.at(name);
  }

  std::string source_;
  std::unique_ptr<Case> case_;
  std::map<std::string, Work> works_;
};

void registerAll(Session& session) {
  for (const char* triangles : {"300000", "1000000"}) {
    const std::string source = std::string("builtin:statues,triangles=") + triangles;
    for (const Row& row : rows()) {
      benchmark::RegisterBenchmark(
          (std::string(row.name) + "/" + triangles).c_str(),
          [&session, source, &row](benchmark::State& state) { session.construct(state, source, row); })
          ->Unit(benchmark::kMillisecond)
          ->UseManualTime();
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
#ifdef OCELLI_BENCH_OSMESA
  const ocelli::Mesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {{0, 1, 2}}};
  benchmark::AddCustomContext("opengl", ocelli::OsMesaRenderer({ocelli::View{}, 8, 8}, triangle).name());
#endif
  ocelli::Session session;
  ocelli::registerAll(session);
  benchmark::Initialize(&argumentCount, arguments);
  if (benchmark::ReportUnrecognizedArguments(argumentCount, arguments)) {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
