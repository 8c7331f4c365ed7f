// Table 3.6 of the dissertation, done again: construction time and memory of a depth image (DI), a layered depth image
// (LDI), an occlusion camera reference image (OCRI, here of the DDOC), a light field (LF), an unstructured light field
// (ULF) and a ray-phase-space representation (RPS) of the scene of the four Happy Buddhas.
//
// Measured: DI, LDI, OCRI, and two that the text does not have: depth images from the corners of the view cell as well,
// and the scene simplified to as many triangles as the OCRI has. Computed from the sampling that the text states, with
// our time for one image: LF, ULF, RPS, and the construction of the LDI as the text has it, with the memory of ours
// that holds what the view cell sees. Missing are truth samples, strictly (coverage.h), over the edges of the cell of 8
// in.
//
// Memory is counted as the text counts it: 4 bytes of colour and 4 of z a sample, 8 more for the place of a sample of
// an OCRI, 4 a ray of colour alone; images whole, also where they are empty; MB are 2^20 bytes. The samples of an LDI
// behind the first layer are charged 4 bytes each for the pixel that they belong to, which the text does not count. A
// mesh has 16 bytes a vertex and 12 a triangle. Times are the best of --runs runs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <functional>

#include "bench/timing.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "oc_core/ocri/layered_mesh.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr double kBytesOfColor = 4;
constexpr double kBytesOfSample = kBytesOfColor + 4;  // and z
constexpr double kBytesOfPlace = 8;
constexpr double kBytesOfPixelNumber = 4;

constexpr double kPixels = double{kDefaultWidth} * kDefaultHeight;
constexpr double kConstructionImagesOfLdi = 4 * 4;
constexpr double kLightFieldImages = 16 * 16;
constexpr double kUnstructuredImages = 32;
/// A ray for each of 16x16 directions of every square millimetre of the screen's sphere that is seen: 38 % of it.
const double kRaysOfPhaseSpace =
    16 * 16 * 0.38 * 4 * kPi * kReferenceDisplayRadiusMetres * kReferenceDisplayRadiusMetres * 1e6;

/// What a representation needs. A text's figure of 0 stands for none.
struct Row {
  std::string name;
  const char* how;
  double seconds = 0, bytes = 0;
  double missing = -1;  ///< of the truth samples, strict; negative where it is not known
  double textSeconds = 0, textMegabytes = 0;
};

/// A representation that is built here.
struct Candidate {
  std::string name;
  std::function<void()> build;
  std::function<Mesh()> mesh;     ///< of what was built
  std::function<double()> bytes;  ///< of the same
  double textSeconds = 0, textMegabytes = 0;
};

void print(const Row& row, double imageSeconds) {
  constexpr double kTextImageSeconds = 0.12;
  fmt::print("| {} | {} | {:.2f} s | {:.1f} | {:.1f} MB | {} |", row.name, row.how, row.seconds,
             row.seconds / imageSeconds, row.bytes / (1 << 20),
             row.missing < 0 ? std::string() : fmt::format("{:.2f} %", 100 * row.missing));
  if (row.textSeconds > 0) {
    fmt::print(" {} s | {:.0f} | {} MB |\n", row.textSeconds, row.textSeconds / kTextImageSeconds, row.textMegabytes);
  } else {
    fmt::print(" | | |\n");
  }
}

double bytesOf(const ReferenceImages& layers) {
  size_t hidden = 0;
  for (size_t layer = 1; layer < layers.size(); ++layer) {
    hidden += layers[layer].sampleCount();
  }
  return kPixels * kBytesOfSample + static_cast<double>(hidden) * (kBytesOfSample + kBytesOfPixelNumber);
}

double bytesOf(const Mesh& mesh) {
  return static_cast<double>(mesh.positions.size()) * (sizeof(glm::vec3) + kBytesOfColor) +
         static_cast<double>(mesh.triangles.size()) * sizeof(glm::uvec3);
}

/// The best time of each, seconds. They take turns, so that what else the machine does hits all alike.
std::vector<double> bestSeconds(int runs, const std::vector<Candidate>& candidates) {
  std::vector<double> best(candidates.size(), 1e30);
  for (int run = 0; run < runs; ++run) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      best[i] = std::min(best[i], milliseconds(candidates[i].build) / 1000);
    }
  }
  return best;
}

/// From the corners and the middles of the edges of the view cell.
double missingRatio(const Mesh& mesh, const Mesh& scene) {
  MissingSamples missing;
  for (const View& view : ViewCell{}.edgeViews(View{})) {
    const PinholeCamera camera(view, kDefaultWidth, kDefaultHeight);
    missing += countMissing(compareFrames(camera, positionImage(camera, scene), positionImage(camera, mesh)));
  }
  return missing.strictRatio();
}

void measure(const Mesh& scene, int runs, int layers) {
  const PinholeCamera camera(View{}, kDefaultWidth, kDefaultHeight);
  ReferenceImages images;
  Mesh mesh;
  const auto ocri = [&](int feedbackRounds) {
    return [&, feedbackRounds] {
      DdocOptions options;
      options.feedbackRounds = feedbackRounds;
      images = {buildDdocImage(buildDdocCamera(camera, scene, options), scene, options.subdivision)};
    };
  };
  const auto imagesMesh = [&] { return unionMesh(images); };
  const auto imagesBytes = [&] { return static_cast<double>(images.size()) * kPixels * kBytesOfSample; };
  const auto ocriBytes = [&] { return kPixels * (kBytesOfSample + kBytesOfPlace); };
  const auto layersMesh = [&] { return layeredMesh(images); };
  const auto layersBytes = [&] { return bytesOf(images); };
  const size_t ocriTriangles = imageMesh(buildDepthImage(camera, scene)).triangles.size();
  const std::vector<Candidate> candidates{
      {"DI", [&] { images = {buildDepthImage(camera, scene)}; }, imagesMesh, imagesBytes, 0.12, 2.6},
      {"OCRI", ocri(DdocOptions{}.feedbackRounds), imagesMesh, ocriBytes, 11.5, 5.2},
      {"OCRI, no feedback", ocri(0), imagesMesh, ocriBytes},
      {fmt::format("LDI, {} layers peeled", layers), [&] { images = buildLayeredDepthImage(camera, scene, layers); },
       layersMesh, layersBytes},
      {"the same, what the cell sees",
       [&] {
         images = buildLayeredDepthImage(camera, scene, layers);
         dropUnseenSamples(images, scene, ViewCell{});
       },
       layersMesh, layersBytes},
      {"DI and 8 corner DIs", [&] { images = buildCornerDepthImages(camera, scene, ViewCell{}, 8); }, imagesMesh,
       imagesBytes},
      {fmt::format("scene simplified to {} K triangles", ocriTriangles / 1000),
       [&] { mesh = simplifyMesh(scene, ocriTriangles, SimplifyMethod::kTopological).mesh; }, [&] { return mesh; },
       [&] { return bytesOf(mesh); }},
  };
  const std::vector<double> seconds = bestSeconds(runs, candidates);
  const double image = seconds[0];

  fmt::print(
      "| representation | how | construction | of a DI | memory | missing | the text: construction | of a DI | memory "
      "|\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    candidate.build();
    print({candidate.name, "measured", seconds[i], candidate.bytes(), missingRatio(candidate.mesh(), scene),
           candidate.textSeconds, candidate.textMegabytes},
          image);
  }
  const auto computed = [&](const char* name, double imageCount, double bytes, double textSeconds,
                            double textMegabytes) {
    print({name, "computed", imageCount * image, bytes, -1, textSeconds, textMegabytes}, image);
  };
  images = buildLayeredDepthImage(camera, scene, layers);
  dropUnseenSamples(images, scene, ViewCell{});
  computed("LDI, 16 images merged", kConstructionImagesOfLdi * 2, bytesOf(images), 3.84, 3);
  computed("LF", kLightFieldImages, kLightFieldImages * kPixels * kBytesOfColor, 30.72, 332.8);
  computed("ULF", kUnstructuredImages, kUnstructuredImages * kPixels * kBytesOfColor, 3.84, 41.6);
  computed("RPS", std::ceil(kRaysOfPhaseSpace / kPixels), kRaysOfPhaseSpace * kBytesOfColor, 6.84, 76);
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Table 3.6: time to construct a representation, and its size. Needs OCELLI_DATA_DIR.");
  int runs = 5;
  int threads = 0;
  int layers = 4;
  std::string scene = "builtin:statues,mesh=buddha.obj,triangles=4603000";
  program.add_option("--runs", runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", threads, "0 stands for all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  program.add_option("--layers", layers, "Of the LDI")->check(CLI::Range(1, kMaxLayers))->capture_default_str();
  program.add_option("--scene", scene, "A scene file or builtin:NAME")->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);
  setThreadCount(threads);
  try {
    const Mesh mesh = loadScene(scene);
    fmt::print("{}: {} triangles, {} threads, {}x{}, best of {} runs\n\n", scene, mesh.triangles.size(), threadCount(),
               kDefaultWidth, kDefaultHeight, runs);
    measure(mesh, runs, layers);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "table_3_6: error: {}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
