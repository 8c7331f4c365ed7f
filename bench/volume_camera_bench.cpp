// What bent rays cost at a volume, beside the straight rays of a pinhole, in the same run: for each camera frames a
// second, samples, and the time of a sample. As Table 4.2 and section 5.3.1.1 have them, of the volumes that
// `builtin:volume` makes with those sizes.
//
// Wall times are the least of --runs, taken in turn for all cameras. The time of a sample is that of the CPU, summed
// over threads, which other work on the machine disturbs less.
#include <cstdio>
#include <filesystem>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/camera/view.h"
#include "oc_core/volume_camera/volume_camera.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "oc_core/volume_render/volume_target.h"

namespace ocelli {
namespace {

struct VolumeCameraBenchChoice {
  std::string volume = "builtin:volume,name=engine";
  std::vector<std::string> cameras{"di"};
  std::string view;
  std::vector<double> steps{0.5, 1};
  int runs = 5;
  int threads = 0;
  int width = 1280;
  int height = 720;
};

struct MeasuredCamera {
  VolumeCamera camera;
  double bestWall = 1e30;
  double bestProcessor = 1e30;
  VolumeImageFacts facts{};
};

void measureStep(const VolumeCameraBenchChoice& choice, VolumeRenderer& renderer, std::vector<MeasuredCamera>& cameras,
                 double step) {
  VolumeRenderOptions options = renderer.options();
  options.step = step;
  renderer.setOptions(options);
  for (MeasuredCamera& each : cameras) {
    each.bestWall = each.bestProcessor = 1e30;
  }
  for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
    for (MeasuredCamera& each : cameras) {
      VolumeImage image;
      double wall = 0;
      const double processor = processorMilliseconds([&] {
        wall = milliseconds([&] {
          image = renderer.render(each.camera.size.x, each.camera.size.y, each.camera.ray, {}, each.camera.hull,
                                  each.camera.isSmooth);
        });
      });
      if (run == 0) {
        each.facts = factsOf(image);
      } else {
        each.bestWall = std::min(each.bestWall, wall);
        each.bestProcessor = std::min(each.bestProcessor, processor);
      }
    }
  }
  const auto sampleTime = [](const MeasuredCamera& each) {
    return each.bestProcessor * 1e6 / static_cast<double>(each.facts.samples);
  };
  for (const MeasuredCamera& each : cameras) {
    const auto pixels = static_cast<double>(each.camera.size.x) * each.camera.size.y;
    fmt::print("{:>5} {:<28} {:>8.2f} Hz {:>8.1f} ms {:>8.1f} M samples {:>6.1f} % of pixels {:>7.2f} ns {:>6.2f}\n",
               step, std::filesystem::path(each.camera.name).stem().string(), 1000 / each.bestWall, each.bestWall,
               static_cast<double>(each.facts.samples) / 1e6, 100 * static_cast<double>(each.facts.touched) / pixels,
               sampleTime(each), sampleTime(each) / sampleTime(cameras.front()));
  }
  std::fflush(stdout);
}

void measureVolumeCameras(const VolumeCameraBenchChoice& choice) {
  VolumeRenderer renderer(loadVolumeScene(choice.volume));
  const VolumeTarget firstHits(renderer);
  const PinholeCamera reference(choice.view.empty() ? View{} : readView(choice.view), choice.width, choice.height);
  std::vector<MeasuredCamera> cameras;
  for (const std::string& name : choice.cameras) {
    cameras.push_back(
        {volumeCamera(name, reference, renderer.scene(), [&]() -> const RayTarget& { return firstHits; })});
  }
  const glm::ivec3 size = renderer.scene().volume->grid().size;
  fmt::print("{}: {}x{}x{} voxels, {}x{} pixels, {} threads; last: the time of a sample, and by that of the first\n",
             choice.volume, size.x, size.y, size.z, choice.width, choice.height, threadCount());
  for (const double step : choice.steps) {
    measureStep(choice, renderer, cameras, step);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("Volumes along the rays of cameras", "volume_camera_bench");
  ocelli::VolumeCameraBenchChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--volume", choice.volume, "A volume")->capture_default_str();
  program.add_option("--cameras", choice.cameras, "Names and files, the pinhole first")->delimiter(',');
  program.add_option("--view", choice.view, "A view file");
  program.add_option("--steps", choice.steps, "Distances of samples, voxels")->delimiter(',');
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measureVolumeCameras);
}
