// Table 3.6 of the dissertation, done again: construction time and memory of a depth image (DI), a layered depth image
// (LDI), an occlusion camera reference image (OCRI, here of the DDOC), a light field (LF), an unstructured light field
// (ULF) and a ray-phase-space representation (RPS) of the scene of the four Happy Buddhas.
//
// Measured: DI, LDI, OCRI. Computed from the sampling that the text states, with our time for one image: LF, ULF, RPS,
// and the LDI as the text builds it. Memory is counted as the text counts it: 4 bytes of colour and 4 of z a sample, 8
// more for the place of a sample of an OCRI, 4 a ray of colour alone; images whole, also where they are empty; MB are
// 2^20 bytes. The samples of an LDI behind the first layer are charged 4 bytes each for the pixel that they belong to,
// which the text does not count. Times are the best of --runs runs.
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
  std::string name;
  const char* how;
  double seconds, bytes;
  double textSeconds, textMegabytes;  ///< 0 where the text has none
};

class Table {
 public:
  Table(double secondsOfOneImage, double textSecondsOfOneImage)
      : image_(secondsOfOneImage), textImage_(textSecondsOfOneImage) {
    fmt::print(
        "| representation | how | construction | of a DI | memory | the text: construction | of a DI | memory |\n");
    fmt::print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  }

  void print(const Row& row) const {
    fmt::print("| {} | {} | {:.2f} s | {:.1f} | {:.1f} MB |", row.name, row.how, row.seconds, row.seconds / image_,
               row.bytes / (1 << 20));
    if (row.textSeconds > 0) {
      fmt::print(" {} s | {:.0f} | {} MB |\n", row.textSeconds, row.textSeconds / textImage_, row.textMegabytes);
    } else {
      fmt::print(" | | |\n");
    }
    std::fflush(stdout);
  }

 private:
  double image_;
  double textImage_;
};

double bytesOf(const std::vector<ReferenceImage>& layers) {
  size_t hidden = 0;
  for (size_t layer = 1; layer < layers.size(); ++layer) {
    hidden += layers[layer].sampleCount();
  }
  return kPixels * (kBytesOfColor + kBytesOfZ) +
         static_cast<double>(hidden) * (kBytesOfColor + kBytesOfZ + kBytesOfPixelNumber);
}

void measure(const Mesh& scene, int runs, int layers) {
  const PinholeCamera camera(View{}, kDefaultWidth, kDefaultHeight);
  const auto secondsOf = [&](const auto& work) { return bestMilliseconds(runs, work) / 1000; };
  constexpr double kTextImage = 0.12;

  const double image = secondsOf([&] { buildDepthImage(camera, scene); });
  const Table table(image, kTextImage);
  table.print({"DI", "measured", image, kPixels * (kBytesOfColor + kBytesOfZ), kTextImage, 2.6});

  std::vector<ReferenceImage> layered;
  const double peeled = secondsOf([&] { layered = buildLayeredDepthImage(camera, scene, layers); });
  table.print({fmt::format("LDI, {} layers peeled", layers), "measured", peeled, bytesOf(layered), 0, 0});
  const double pruned = secondsOf([&] {
    layered = buildLayeredDepthImage(camera, scene, layers);
    dropUnseenSamples(layered, scene, ViewCell{});
  });
  table.print({"the same, what the cell sees", "measured", pruned, bytesOf(layered), 0, 0});
  table.print({"LDI, 16 images merged", "time computed, memory of the row above", kConstructionImagesOfLdi * 2 * image,
               bytesOf(layered), 3.84, 3});

  table.print({"LF", "computed", kLightFieldImages * image, kLightFieldImages * kPixels * kBytesOfColor, 30.72, 332.8});
  table.print(
      {"ULF", "computed", kUnstructuredImages * image, kUnstructuredImages * kPixels * kBytesOfColor, 3.84, 41.6});
  table.print(
      {"RPS", "computed", std::ceil(kRaysOfPhaseSpace / kPixels) * image, kRaysOfPhaseSpace * kBytesOfColor, 6.84, 76});

  const auto ocri = [&](int feedbackRounds) {
    DdocOptions options;
    options.feedbackRounds = feedbackRounds;
    return secondsOf([&] { buildDdocImage(buildDdocCamera(camera, scene, options), scene, options.subdivision); });
  };
  const double ocriBytes = kPixels * (kBytesOfColor + kBytesOfZ + kBytesOfPlace);
  table.print({"OCRI, no feedback", "measured", ocri(0), ocriBytes, 0, 0});
  table.print({"OCRI", "measured", ocri(DdocOptions{}.feedbackRounds), ocriBytes, 11.5, 5.2});
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
