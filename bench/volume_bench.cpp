// What volumes along rays cost: beside VTK's ray caster on the CPU (vtkFixedPointVolumeRayCastMapper), at the same
// error against the reference, and along the rays of cameras that bend them beside the pinhole's.
//
// Times are of the CPU, summed over threads, the least of --runs, taken in turn for all. VTK is there where its library
// was found.
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "bench/volume_bench_cameras.h"
#include "bench/volume_peer.h"
#include "oc_core/render/pixel_tiles.h"
#include "oc_core/volume_render/march_kernel.h"
#include "oc_core/volume_render/volume_reference.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {
namespace {

struct VolumeBenchChoice {
  std::vector<std::string> scenes{"builtin:volume,name=marschner-lobb"};
  int runs = 3;
  int threads = 0;
  int width = 720;
  int height = 480;
  std::vector<double> steps{2, 1, 0.5, 0.25};
  double referenceStep = 1.0 / 16;
  int referenceSize = 180;  ///< pixels across, of the image whose error is measured
  double cameraStep = 1;
  bool shadedOnly = false;
  bool withPeer = true;
  bool withCameras = true;
};

struct ImageErrors {
  double rms = 0;
  double greatest = 0;
};

ImageErrors errorsOf(const Image<glm::vec4>& image, const Image<glm::vec4>& reference) {
  ImageErrors errors;
  for (size_t i = 0; i < image.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double difference = std::abs(static_cast<double>(image[i][c]) - static_cast<double>(reference[i][c]));
      errors.greatest = std::max(errors.greatest, difference);
      errors.rms += difference * difference;
    }
  }
  errors.rms = std::sqrt(errors.rms / (3.0 * static_cast<double>(image.size())));
  return errors;
}

Image<glm::vec4> colorsOf(const VolumeImage& image) {
  Image<glm::vec4> colors(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    colors[i] = image[i].color;
  }
  return colors;
}

/// The same view of fewer pixels, for what takes the reference long.
PinholeCamera smaller(const View& view, const VolumeBenchChoice& choice) {
  return {view, choice.referenceSize, choice.referenceSize * choice.height / choice.width};
}

View benchView() {
  View view;
  view.eye = {3, 2, 5};
  return view;
}

void measureErrors(const VolumeBenchChoice& choice, const VolumeScene& scene) {
  const PinholeCamera small = smaller(benchView(), choice);
  const PinholeCamera camera(benchView(), choice.width, choice.height);
  const Image<glm::vec4> reference = colorsOf(renderReference(small, scene, choice.referenceStep));
  std::vector<VolumePeer> peers = choice.withPeer ? volumePeers() : std::vector<VolumePeer>{};
  // What VTK's image comes to with small steps is not the reference: its numbers are of 15 bits, its rays begin and end
  // elsewhere at the faces, and it lights one side of a layer. So its own image with steps of an eighth is taken as
  // well. That tells how it converges, not how good it is: nothing about times at equal error follows from it.
  constexpr double kOwnStep = 1.0 / 8;
  fmt::print("{:<18} {:>6} {:>9} {:>9} {:>9} {:>9} {:>12}\n", "", "step", "RMSE", "greatest", "own RMSE", "ms",
             "samples");
  VolumeRenderer renderer(scene);
  std::vector<std::function<VolumePeer::Picture(double)>> prepared;
  for (VolumePeer& peer : peers) {
    prepared.push_back(peer.prepare(scene));
  }
  std::vector<Image<glm::vec4>> ownOfPeers;
  for (const auto& picture : prepared) {
    ownOfPeers.push_back(picture(kOwnStep)(small));
  }
  renderer.setOptions({.step = kOwnStep});
  const Image<glm::vec4> own = colorsOf(renderVolume(small, renderer));
  for (const double step : choice.steps) {
    renderer.setOptions({.step = step});
    const Image<glm::vec4> image = colorsOf(renderVolume(small, renderer));
    const ImageErrors errors = errorsOf(image, reference);
    const double ownError = errorsOf(image, own).rms;
    double best = 1e30;
    std::vector<double> bestOfPeers(peers.size(), 1e30);
    uint64_t samples = 0;
    std::vector<ImageErrors> errorsOfPeers;
    std::vector<double> ownErrorsOfPeers;
    for (size_t i = 0; i < prepared.size(); ++i) {
      const Image<glm::vec4> theirs = prepared[i](step)(small);
      errorsOfPeers.push_back(errorsOf(theirs, reference));
      ownErrorsOfPeers.push_back(errorsOf(theirs, ownOfPeers[i]).rms);
    }
    for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
      const double time = processorMilliseconds([&] { samples = samplesOf(renderVolume(camera, renderer)); });
      best = run > 0 ? std::min(best, time) : best;
      for (size_t i = 0; i < prepared.size(); ++i) {
        const auto picture = prepared[i](step);
        const double peerTime = processorMilliseconds([&] { picture(camera); });
        bestOfPeers[i] = run > 0 ? std::min(bestOfPeers[i], peerTime) : bestOfPeers[i];
      }
    }
    fmt::print("{:<18} {:>6} {:>9.5f} {:>9.5f} {:>9.5f} {:>9.1f} {:>12}\n", "ocelli", step, errors.rms, errors.greatest,
               ownError, best, samples);
    for (size_t i = 0; i < peers.size(); ++i) {
      fmt::print("{:<18} {:>6} {:>9.5f} {:>9.5f} {:>9.5f} {:>9.1f}\n", peers[i].name, step, errorsOfPeers[i].rms,
                 errorsOfPeers[i].greatest, ownErrorsOfPeers[i], bestOfPeers[i]);
    }
    std::fflush(stdout);
  }
}

struct TimedCamera {
  std::string name;
  std::function<VolumeImage()> render;
  std::function<void()> makeRays;
  double best = 1e30;
  double bestOfRays = 1e30;
  uint64_t samples = 0;
};

template <class C>
TimedCamera timed(const std::string& name, const C& camera, const VolumeRenderer& renderer) {
  return {name, [camera, &renderer] { return renderVolume(camera, renderer); },
          [camera] {
            castTiles<float>(
                camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); },
                [](std::span<const RayPath> rays, std::span<float> ends) {
                  for (size_t i = 0; i < rays.size(); ++i) {
                    ends[i] = rays[i].tMax();
                  }
                });
          }};
}

/// Rays that bend in the middle of the volume.
void measureCameras(const VolumeBenchChoice& choice, const VolumeScene& scene) {
  const VolumeRenderer renderer(scene, {.step = choice.cameraStep});
  std::vector<TimedCamera> cameras;
  forEachVolumeCamera(choice.width, choice.height,
                      [&](const char* name, const auto& camera) { cameras.push_back(timed(name, camera, renderer)); });
  for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
    for (TimedCamera& camera : cameras) {
      const double time = processorMilliseconds([&] { camera.samples = samplesOf(camera.render()); });
      const double timeOfRays = processorMilliseconds(camera.makeRays);
      if (run > 0) {
        camera.best = std::min(camera.best, time);
        camera.bestOfRays = std::min(camera.bestOfRays, timeOfRays);
      }
    }
  }
  const auto bySample = [](const TimedCamera& c) {
    return (c.best - c.bestOfRays) * 1e6 / static_cast<double>(c.samples);
  };
  // Making rays, which renderers of meshes need as well, is told apart.
  fmt::print("{:<24} {:>9} {:>9} {:>12} {:>10} {:>8}\n", "", "ms", "of rays", "samples", "ns/sample", "ratio");
  for (const TimedCamera& camera : cameras) {
    fmt::print("{:<24} {:>9.1f} {:>9.1f} {:>12} {:>10.2f} {:>8.2f}\n", camera.name, camera.best, camera.bestOfRays,
               camera.samples, bySample(camera), bySample(camera) / bySample(cameras.front()));
  }
  std::fflush(stdout);
}

/// VTK's volumes end at the outermost voxels' centres.
std::vector<ClipPlane> centersAlone(const VolumeScene& scene) {
  std::vector<ClipPlane> clips;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 way = glm::normalize(glm::dvec3(scene.worldFromIndex[axis]));
    const glm::dvec3 last = glm::dvec3(scene.worldFromIndex * glm::dvec4(glm::dvec3(scene.volume->grid().size - 1), 1));
    clips.push_back({way, glm::dot(way, glm::dvec3(scene.worldFromIndex[3]))});
    clips.push_back({-way, -glm::dot(way, last)});
  }
  return clips;
}

void measureVolumes(const VolumeBenchChoice& choice) {
  fmt::print("{} threads, {}, {} x {}\n", threadCount(), marchInstructionSet(), choice.width, choice.height);
  for (const std::string& source : choice.scenes) {
    VolumeScene scene = loadVolumeScene(source);
    scene.clips = centersAlone(scene);
    const glm::ivec3& size = scene.volume->grid().size;
    for (const bool isShaded : {false, true}) {
      if (choice.shadedOnly && !isShaded) {
        continue;
      }
      scene.appearance.shading.isOn = isShaded;
      fmt::print("\n{}, {} x {} x {}, {}, {}\n", source, size.x, size.y, size.z, nameOf(scene.volume->type()),
                 isShaded ? "shaded" : "not shaded");
      if (!choice.steps.empty()) {
        measureErrors(choice, scene);
      }
      if (choice.withCameras) {
        measureCameras(choice, scene);
      }
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::VolumeBenchChoice choice;
  CLI::App program("Volumes along rays, beside VTK's", "volume_bench");
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scenes, "Volumes")->capture_default_str();
  program.add_option("--step", choice.steps, "Distances of samples, in voxels")->capture_default_str();
  program.add_option("--reference-step", choice.referenceStep, "Of the reference")->capture_default_str();
  program.add_option("--reference-width", choice.referenceSize, "Pixels of the reference")->capture_default_str();
  program.add_option("--camera-step", choice.cameraStep, "Of rays that bend")->capture_default_str();
  program.add_flag("--shaded", choice.shadedOnly, "Shaded alone");
  program.add_flag("!--no-peer", choice.withPeer, "Not VTK");
  program.add_flag("!--no-cameras", choice.withCameras, "Not along rays that bend");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measureVolumes);
}
