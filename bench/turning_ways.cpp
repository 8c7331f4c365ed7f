#include "bench/turning_ways.h"

#include <algorithm>

#include "bench/timing.h"
#include "display_driver/pacing/turning_source.h"
#include "display_sim/slicing/turn_about_axis.h"
#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/pack/cluster_cut.h"

namespace ocelli {
namespace {

constexpr double kRefreshHertz = 24;

HostTime timeOf(int refresh) {
  return HostTime(
      std::chrono::duration_cast<HostTime::duration>(std::chrono::duration<double>(refresh / kRefreshHertz)));
}

std::shared_ptr<TurningSource> turning(const Mesh& ordered, const DisplayProfile& profile) {
  return std::make_shared<TurningSource>(ordered, profile, SliceOptions{}, kTurnDegrees * kRefreshHertz);
}

View turned(View view, double radians) {
  for (glm::vec3* each : {&view.eye, &view.target, &view.up}) {
    *each = turnedAboutAxis(*each, radians);
  }
  return view;
}

/// Lights in `all` what `part` lights.
void join(Volume& all, const Volume& part) {
  parallelFor(static_cast<size_t>(all.slices()), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::span<uint8_t> to = all.slice(static_cast<int>(i));
      const std::span<const uint8_t> from = part.slice(static_cast<int>(i));
      std::ranges::transform(to, from, to.begin(), [](uint8_t a, uint8_t b) { return static_cast<uint8_t>(a | b); });
    }
  });
}

}  // namespace

TurningWay geometryWay(const Mesh& ordered, const DisplayProfile& profile) {
  return [source = turning(ordered, profile)](int refresh) {
    return std::vector{milliseconds([&] { source->volumeFor(timeOf(refresh)); })};
  };
}

TurningWay ocriWay(std::function<ReferenceImages(const PinholeCamera& reference)> build, int width, int height,
                   const DisplayProfile& profile) {
  return [build = std::move(build), slicer = std::make_shared<Slicer>(profile), width, height](int refresh) {
    const double radians = kTurnDegrees * refresh * kPi / 180;
    const PinholeCamera reference(turned(View{}, -radians), width, height);
    ReferenceImages images;
    Mesh mesh;
    return std::vector{milliseconds([&] { images = build(reference); }), milliseconds([&] {
                         mesh = unionMesh(images);
                         turnAboutAxis(mesh.positions, radians, mesh.positions);
                       }),
                       milliseconds([&] {
                         slicer->slice(SliceMesh(mesh));
                         slicer->takeShared();
                       })};
  };
}

PartsTimes sliceInParts(const PackedScene& scene, size_t trianglesOfPart, int runs, const DisplayProfile& profile) {
  OC_CHECK(profile.colorBitsPerChannel == 1, "levels are joined as bits");
  PartsTimes times;
  Volume all(profile);
  Slicer slicer(profile);
  const std::vector<ClusterChoice> clusters = allClusters(scene);
  for (size_t first = 0; first < clusters.size();) {
    size_t triangles = 0;
    std::vector<ClusterChoice> part;
    for (; first < clusters.size() && triangles < trianglesOfPart; ++first) {
      triangles += scene.cluster(clusters[first].group, clusters[first].cluster).triangles;
      part.push_back(clusters[first]);
    }
    times.streamed += leastMilliseconds(runs, [&] {
      Mesh mesh = meshOf(scene, part);
      turnAboutAxis(mesh.positions, kTurnDegrees * kPi / 180, mesh.positions);
      join(all, slicer.slice(SliceMesh(mesh)));
    });
    const auto source = turning(orderedForSlicing(weldedMeshOf(scene, part)), profile);
    int refresh = 0;
    times.standing += leastMilliseconds(runs, [&] { join(all, *source->volumeFor(timeOf(refresh++)).volume); });
    ++times.parts;
  }
  return times;
}

}  // namespace ocelli
