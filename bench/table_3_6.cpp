// Table 3.6 of the dissertation, done again: construction time and memory of a depth image (DI), a layered depth image
// (LDI), an occlusion camera reference image (OCRI, here of the DDOC), a light field (LF), an unstructured light field
// (ULF) and a ray-phase-space representation (RPS) of the scene of the four Happy Buddhas.
//
// Measured: DI, LDI, OCRI. Computed from the sampling that the text states, with our time for one image: LF, ULF, RPS,
// and the LDI as the text builds it. Memory is counted as the text counts it: 4 bytes of colour and 4 of z a sample, 8
// more for the place of a sample of an OCRI, 4 a ray of colour alone; images whole, also where they are empty; MB are
// 2^20 bytes. The samples of an LDI behind the first layer are charged 4 bytes each for the pixel that they belong to,
// which the text does not count. Times are medians of --runs runs, after one run that is not counted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "bench/timing.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/layered_depth_image.h"
#include "oc_core/scene/scene_source.h"

namespace ocelli {
namespace {

constexpr double kBytesOfColor = 4;
constexpr double kBytesOfZ = 4;
constexpr double kBytesOfPlace = 8;
constexpr double kBytesOfPixelNumber = 4;

constexpr double kPixels = double{kDefaultWidth} * kDefaultHeight;
constexpr double kConstructionImagesOfLdi = 4 * 4;
constexpr double kLightFieldImages = 16 * 16;
constexpr double kUnstructuredImages = 32;
/// A ray for each of 16x16 directions of every square millimetre of the screen's sphere that is seen: 38 % of it.
const double kRaysOfPhaseSpace =
    16 * 16 * 0.38 * 4 * kPi * kReferenceDisplayRadiusMetres * kReferenceDisplayRadiusMetres * 1e6;

struct Row {
  const char* name;
  const char* how;
  double seconds, bytes;
  double textSeconds, textMegabytes;  ///< 0 where the text has none
};

void print(const Row& row) {
  const auto text = [](double value, const char* unit) {
    return value > 0 ? fmt::format("{} {}", value, unit) : std::string();
  };
  fmt::print("| {} | {} | {:.2f} s | {:.1f} MB | {} | {} |\n", row.name, row.how, row.seconds, row.bytes / (1 << 20),
             text(row.textSeconds, "s"), text(row.textMegabytes, "MB"));
  std::fflush(stdout);
}

void measure(const Mesh& scene, int runs, int layers) {
  const PinholeCamera camera(View{}, kDefaultWidth, kDefaultHeight);
  const auto secondsOf = [&](const auto& work) { return medianMilliseconds(runs, work) / 1000; };

  const double image = secondsOf([&] { buildDepthImage(camera, scene); });
  print({"DI", "measured", image, kPixels * (kBytesOfColor + kBytesOfZ), 0.12, 2.6});

  std::vector<ReferenceImage> layered;
  const double ldi = secondsOf([&] { layered = buildLayeredDepthImage(camera, scene, layers); });
  size_t hidden = 0;
  for (size_t layer = 1; layer < layered.size(); ++layer) {
    hidden += layered[layer].sampleCount();
  }
  const double ldiBytes = kPixels * (kBytesOfColor + kBytesOfZ) +
                          static_cast<double>(hidden) * (kBytesOfColor + kBytesOfZ + kBytesOfPixelNumber);
  const std::string ldiName = fmt::format("LDI, {} layers peeled", layers);
  print({ldiName.c_str(), "measured", ldi, ldiBytes, 0, 0});
  print({"LDI, 16 images merged", "time computed, memory of the peeled one", kConstructionImagesOfLdi * 2 * image,
         ldiBytes, 3.84, 3});

  print({"LF", "computed", kLightFieldImages * image, kLightFieldImages * kPixels * kBytesOfColor, 30.72, 332.8});
  print({"ULF", "computed", kUnstructuredImages * image, kUnstructuredImages * kPixels * kBytesOfColor, 3.84, 41.6});
  print(
      {"RPS", "computed", std::ceil(kRaysOfPhaseSpace / kPixels) * image, kRaysOfPhaseSpace * kBytesOfColor, 6.84, 76});

  const auto ocri = [&](int feedbackRounds) {
    DdocOptions options;
    options.feedbackRounds = feedbackRounds;
    return secondsOf([&] { buildDdocImage(buildDdocCamera(camera, scene, options), scene, options.subdivision); });
  };
  const double ocriBytes = kPixels * (kBytesOfColor + kBytesOfZ + kBytesOfPlace);
  print({"OCRI, no feedback", "measured", ocri(0), ocriBytes, 0, 0});
  print({"OCRI", "measured", ocri(DdocOptions{}.feedbackRounds), ocriBytes, 11.5, 5.2});
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Table 3.6: time to construct a representation, and its size. Needs OCELLI_DATA_DIR.");
  int runs = 5;
  int threads = 0;
  int layers = 4;
  std::string scene = "builtin:statues,mesh=buddha.obj,triangles=4603000";
  program.add_option("--runs", runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", threads, "0 stands for all cores")->check(CLI::Range(0, 1024))->capture_default_str();
  program.add_option("--layers", layers, "Of the LDI")->check(CLI::Range(1, kMostLayers))->capture_default_str();
  program.add_option("--scene", scene, "A scene file or builtin:NAME")->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);
  setThreadCount(threads);
  try {
    const Mesh mesh = loadScene(scene);
    fmt::print("{}: {} triangles, {} threads, {}x{}, medians of {} runs\n\n", scene, mesh.triangles.size(),
               threadCount(), kDefaultWidth, kDefaultHeight, runs);
    fmt::print("| representation | how | construction | memory | the text: construction | memory |\n");
    fmt::print("| --- | --- | ---: | ---: | ---: | ---: |\n");
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
