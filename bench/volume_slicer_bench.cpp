// Volumes into slices while their transfer function moves: what one volume for the display takes, by volume and
// transfer function, beside what the slicer of meshes takes for a scene, and what the display's memory takes to be
// written.
//
// A time is the least of --runs, whose runs of all ways are interleaved. The transfer function moves in every run: its
// tables are made anew. CPU time is that of all threads together: half of it is what two cores take by themselves.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <optional>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/slicing/slicer.h"
#include "display_sim/volume_slicing/volume_slicer.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct Choice {
  int runs = 20;
  int threads = 0;
  int width = 0;
  int height = 0;
  std::string profile = "perspecta";
  std::vector<std::string> volumes{"builtin:volume,name=engine", "builtin:volume,name=skull",
                                   "builtin:volume,name=marschner-lobb"};
  std::string scene = "builtin:statues,mesh=buddha.obj,triangles=600000";
};

/// The same with all values moved by a share of the range.
TransferFunction movedBy(const TransferFunction& transfer, double shift) {
  std::vector<TransferPoint> points = transfer.points();
  for (TransferPoint& point : points) {
    point.value += shift;
  }
  return {std::move(points), transfer.opacityLength()};
}

/// All values a little opaque: no voxel is left out.
TransferFunction hazeOf(const ValueRange& range, double opacityLength) {
  return {{{range.least, {0.2, 0.4, 1}, 0.02}, {range.greatest, {1, 0.8, 0.4}, 0.5}}, opacityLength};
}

double leastOf(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

/// Every byte of a volume.
double fillMilliseconds(Volume& volume, uint8_t byte) {
  return milliseconds([&] {
    parallelFor(static_cast<size_t>(volume.slices()), 1, [&](size_t begin, size_t end) {
      for (size_t slice = begin; slice < end; ++slice) {
        std::ranges::fill(volume.slice(static_cast<int>(slice)), byte);
      }
    });
  });
}

void measureVolume(const std::string& source, const DisplayProfile& profile, const Choice& choice, Slicer& meshSlicer,
                   const std::optional<SliceMesh>& mesh) {
  const VolumeScene scene = loadVolumeScene(source);
  std::optional<SweptSamples> samples;
  double sampling = 0;
  const double samplingProcessor =
      processorMilliseconds([&] { sampling = milliseconds([&] { samples.emplace(scene, profile); }); });
  const ValueRange& range = samples->range();
  const double step = (range.greatest - range.least) / 1000;
  const TransferFunction haze = hazeOf(range, scene.appearance.transfer.opacityLength());
  Volume blank(profile);
  VolumeSlicer slicer(profile);
  struct Way {
    const char* name;
    const TransferFunction& transfer;
    std::vector<double> tables{};
    std::vector<double> whole{};
    std::vector<double> processor{};  ///< of all threads
    size_t lit = 0;
  };
  Way ways[] = {{"its own", scene.appearance.transfer}, {"haze everywhere", haze}};
  std::vector<double> meshes;
  std::vector<double> fills;
  for (int run = 0; run <= choice.runs; ++run) {
    for (Way& way : ways) {
      const TransferFunction transfer = movedBy(way.transfer, run % 7 * step);
      double tables = 0;
      double whole = 0;
      const double processor = processorMilliseconds([&] {
        whole = milliseconds([&] {
          std::optional<SweptLight> light;
          tables =
              milliseconds([&] { light.emplace(transfer, range, samples->sceneLengthOfUnit(), samples->sweep()); });
          slicer.slice(*samples, *light);
        });
      });
      if (run > 0) {
        way.tables.push_back(tables);
        way.whole.push_back(whole);
        way.processor.push_back(processor);
      } else {
        way.lit = slicer.takeVolume().litVoxels();
      }
    }
    fills.push_back(fillMilliseconds(blank, static_cast<uint8_t>(run)));
    if (mesh) {
      meshes.push_back(milliseconds([&] { meshSlicer.slice(*mesh); }));
    }
  }
  const glm::ivec3& size = scene.volume->grid().size;
  fmt::print("{} ({}x{}x{}): sampled in {:.0f} ms, CPU time {:.0f} ms, {:.0f} MB, {:.1f} M voxels of the display\n",
             source, size.x, size.y, size.z, sampling, samplingProcessor, static_cast<double>(samples->bytes()) / 1e6,
             static_cast<double>(samples->bricks() * kSweptBrickVoxels) / 1e6);
  for (const Way& way : ways) {
    fmt::print(
        "  {:<18} {:6.1f} ms, of it tables {:5.2f} ms; CPU time {:6.1f} ms; {:.2f} M lit voxels; {:.1f} volumes/s\n",
        way.name, leastOf(way.whole), leastOf(way.tables), leastOf(way.processor), static_cast<double>(way.lit) / 1e6,
        1000 / leastOf(way.whole));
    if (mesh) {
      fmt::print("  {:<18} {:6.2f} times the slicer of meshes ({:.1f} ms)\n", "", leastOf(way.whole) / leastOf(meshes),
                 leastOf(meshes));
    }
  }
  fmt::print("  {:<18} {:6.1f} ms; a refresh of the display {:.1f} ms\n", "memory filled", leastOf(fills),
             1000 / profile.refreshHertz());
}

void measure(const Choice& choice) {
  const DisplayProfile profile = loadProfile(choice.profile);
  Slicer meshSlicer(profile);
  std::optional<SliceMesh> mesh;
  if (!choice.scene.empty()) {
    const Mesh scene = orderedForSlicing(loadScene(choice.scene));
    mesh.emplace(scene);
    fmt::print("{}: {} triangles, {} threads, {}\n", choice.scene, scene.triangles.size(), threadCount(), profile.name);
  }
  for (const std::string& volume : choice.volumes) {
    measureVolume(volume, profile, choice, meshSlicer, mesh);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Volumes into slices while their transfer function moves", "volume_slicer_bench");
  ocelli::addCommonOptions(program, choice);
  program.add_option("--profile", choice.profile, "The display");
  program.add_option("--volumes", choice.volumes, "What is sliced")->type_name("VOLUME ...");
  program.add_option("--scene", choice.scene, "A scene for the slicer of meshes; empty: none");
  return ocelli::runProgram(program, argumentCount, arguments, choice,
                            [](const ocelli::Choice& c) { ocelli::measure(c); });
}
