// Volumes along rays with OpenGL, beside the same on the CPU, in the same run: a pinhole and a general pinhole, whose
// rays the shader makes, a graph camera and a curved ray camera, whose rays the CPU makes and uploads.
//
// Times of the CPU are wall times of all threads. Those of OpenGL end when the GPU has finished and the image has been
// read back; "kept" leaves it on the GPU. The least of several runs counts, all taken in turn.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "bench/volume_bench_cameras.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/volume_gl/gl_volume_renderer.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct GlVolumeChoice {
  std::vector<std::string> scenes{"builtin:volume,name=engine"};
  std::string provider = "auto";
  std::string json;
  int runs = 3;
  int threads = 0;
  int width = 720;
  int height = 480;
};

double greatestDifference(const VolumeImage& a, const VolumeImage& b) {
  double greatest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      greatest = std::max(greatest, std::abs(static_cast<double>(a[i].color[c]) - static_cast<double>(b[i].color[c])));
    }
  }
  return greatest;
}

struct Timed {
  std::function<void()> draw;
  double least = 1e30;
};

/// Least times of all, in turn; the first round is not counted.
void timeInTurn(std::vector<Timed>& all, int runs) {
  for (int run = 0; run <= runs; ++run) {
    for (Timed& each : all) {
      const double time = milliseconds(each.draw);
      each.least = run > 0 ? std::min(each.least, time) : each.least;
    }
  }
}

template <class C>
Json measureCamera(const std::string& name, const C& camera, const VolumeRenderer& cpu, const GlVolumeRenderer& exact,
                   const GlVolumeRenderer& hardware, int runs) {
  const GladGLContext& gl = exact.context().gl();
  VolumeImage expected;
  VolumeImage got;
  VolumeImage filtered;
  const auto keep = [&] {
    if constexpr (std::same_as<C, PinholeCamera> || std::same_as<C, GpcCamera>) {
      const GlVolumeRenderer::Picture picture = exact.drawOnGpu(camera);
      gl.Finish();
    } else {
      const GlVolumeRenderer::Picture picture = exact.drawOnGpu(
          camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); });
      gl.Finish();
    }
  };
  std::vector<Timed> all{{[&] { expected = renderVolume(camera, cpu); }},
                         {[&] { got = renderVolumeOnGpu(camera, exact); }},
                         {keep},
                         {[&] { filtered = renderVolumeOnGpu(camera, hardware); }}};
  timeInTurn(all, runs);
  const double off = greatestDifference(expected, got) * 255;
  const double filteredOff = greatestDifference(expected, filtered) * 255;
  fmt::print("  {:<16} {:>9.1f} {:>9.1f} {:>9.1f} {:>7.2f} {:>9.1f} {:>7.2f} {:>9.2f} {:>9.2f} {:>11} {:>11}\n", name,
             all[0].least, all[1].least, all[2].least, all[1].least / all[0].least, all[3].least,
             all[3].least / all[0].least, off, filteredOff, samplesOf(expected), samplesOf(got));
  std::fflush(stdout);
  return {{"camera", name},
          {"cpuMs", all[0].least},
          {"glMs", all[1].least},
          {"glKeptMs", all[2].least},
          {"glPerCpu", all[1].least / all[0].least},
          {"hardwareFilterMs", all[3].least},
          {"greatestDifferenceOf255", off},
          {"hardwareFilterDifferenceOf255", filteredOff},
          {"cpuSamples", samplesOf(expected)},
          {"glSamples", samplesOf(got)}};
}

Json measureScene(GlContext& context, const GlVolumeChoice& choice, VolumeScene scene) {
  const VolumeRenderer cpu(scene);
  std::unique_ptr<GlVolumeRenderer> exact;
  const double upload = milliseconds([&] {
    exact = std::make_unique<GlVolumeRenderer>(context, scene);
    context.gl().Finish();
  });
  const GlVolumeRenderer hardware(context, scene, {}, GlVolumeFilter::kHardware);
  const VolumeAppearance appearance = scene.appearance;
  const double transfer = leastMilliseconds(choice.runs, [&] {
    exact->setAppearance(appearance);
    context.gl().Finish();
  });
  fmt::print("  upload {:.1f} ms, another transfer function {:.1f} ms\n", upload, transfer);
  fmt::print("  {:<16} {:>9} {:>9} {:>9} {:>7} {:>9} {:>7} {:>9} {:>9} {:>11} {:>11}\n", "", "CPU ms", "GL ms",
             "kept ms", "/CPU", "filter ms", "/CPU", "off /255", "filter", "CPU samples", "GL samples");
  Json cameras = Json::array();
  forEachVolumeCamera(choice.width, choice.height, [&](const char* name, const auto& camera) {
    cameras.push_back(measureCamera(name, camera, cpu, *exact, hardware, choice.runs));
  });
  return {{"uploadMs", upload}, {"transferMs", transfer}, {"cameras", cameras}};
}

void measureGlVolumes(const GlVolumeChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const GlScope scope(*context);
  const GlInfo& info = context->info();
  fmt::print("{} through {}, {}: {}\n{}x{}, {} threads, best of {} runs\n", info.renderer, nameOf(info.provider),
             info.isSoftware ? "a software renderer" : "a GPU", info.version, choice.width, choice.height,
             threadCount(), choice.runs);
  Json report{{"renderer", info.renderer},     {"provider", nameOf(info.provider)},
              {"isSoftware", info.isSoftware}, {"version", info.version},
              {"width", choice.width},         {"height", choice.height},
              {"threads", threadCount()},      {"runs", choice.runs},
              {"scenes", Json::array()}};
  for (const std::string& source : choice.scenes) {
    VolumeScene scene = loadVolumeScene(source);
    const glm::ivec3 size = scene.volume->grid().size;
    for (const bool isShaded : {false, true}) {
      scene.appearance.shading.isOn = isShaded;
      fmt::print("\n{}, {}x{}x{}, {}, {}\n", source, size.x, size.y, size.z, nameOf(scene.volume->type()),
                 isShaded ? "shaded" : "not shaded");
      Json figures{{"scene", source}, {"voxels", {size.x, size.y, size.z}}, {"isShaded", isShaded}};
      figures.update(measureScene(*context, choice, scene));
      report["scenes"].push_back(std::move(figures));
    }
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, report.dump(2) + "\n");
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Volumes along rays with OpenGL and on the CPU.", "gl_volume_bench");
  GlVolumeChoice choice;
  program.add_option("--scene", choice.scenes, "Volumes")->capture_default_str();
  program.add_option("--provider", choice.provider, "auto, egl or osmesa")->capture_default_str();
  addCommonOptions(program, choice);
  program.add_option("--json", choice.json, "Write the same figures to a file");
  return runProgram(program, argumentCount, arguments, choice, measureGlVolumes);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
