// Rays at reference images: the pyramid against Embree, on the image's own mesh and on the geometry, and against the
// text's steps along projections. All with the reflected rays of `builtin:mirror`, in the same run.
//
// Times are wall times of all threads, the least of several runs; "build" of a camera is its reference images, of
// Embree the acceleration structure.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <memory>

#include "bench/timing.h"
#include "oc_core/base/parallel.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/depth_rays/stepped_image.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/secondary_rays.h"

namespace ocelli {
namespace {

struct BenchChoice {
  std::vector<size_t> triangles{0, 300'000, 1'000'000};
  std::vector<std::string> cameras{"di", "spoc", "ddoc", "cell"};
  int runs = 3;
};

struct Found {
  double milliseconds = 0;
  RayCost cost;
  std::vector<float> t;  ///< of each ray; 0 where it meets nothing
};

/// `meet(path, cost)` is t, or 0, for each ray.
template <class Meet>
Found castAll(const std::vector<RayPath>& paths, int runs, const Meet& meet) {
  Found found{0, {}, std::vector<float>(paths.size())};
  constexpr size_t kChunks = 64;
  std::vector<RayCost> costs(kChunks);
  found.milliseconds = leastMilliseconds(runs, [&] {
    costs.assign(kChunks, {});
    parallelChunks(paths.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        found.t[i] = meet(paths[i], costs[chunk]);
      }
    });
  });
  for (const RayCost& cost : costs) {
    found.cost += cost;
  }
  return found;
}

Found castAt(const RayScene& scene, const std::vector<RayPath>& paths, int runs) {
  return castAll(paths, runs, [&](const RayPath& path, RayCost&) {
    const Fragment fragment = scene.intersect(path);
    return fragment.covered() ? fragment.t : 0;
  });
}

void print(const std::string& name, double build, double structure, const Found& found, const Found* exact) {
  const auto rays = static_cast<double>(found.t.size());
  size_t alike = 0;
  size_t hits = 0;
  for (size_t i = 0; exact != nullptr && i < found.t.size(); ++i) {
    hits += exact->t[i] > 0;
    alike += exact->t[i] > 0 && found.t[i] > 0 && std::abs(found.t[i] - exact->t[i]) < 0.005f;
  }
  fmt::print("  {:<28} {:>9.1f} {:>9.1f} {:>9.1f} {:>8.3f} {:>7.1f} {:>8.1f} {:>9}\n", name, build, structure,
             found.milliseconds, 1000 * found.milliseconds / rays, static_cast<double>(found.cost.steps()) / rays,
             static_cast<double>(found.cost.boxes) / rays,
             hits > 0 ? fmt::format("{:.2f} %", 100 * static_cast<double>(alike) / static_cast<double>(hits)) : "");
}

void measureCamera(const std::string& name, const ShadedScene& scene, const PinholeCamera& reference,
                   const ViewCell& cell, const std::vector<RayPath>& paths, int runs) {
  const CameraChoice choice = cameraChoice(name, cell);
  ReferenceImages images;
  const double build = leastMilliseconds(runs, [&] { images = buildReferenceImages(choice, reference, scene.cast); });
  std::unique_ptr<DepthImageTarget> target;
  const double structure = leastMilliseconds(runs, [&] { target = std::make_unique<DepthImageTarget>(images); });
  const Found exact = castAll(paths, runs, [&](const RayPath& path, RayCost& cost) {
    const auto hit = target->hit(path, cost);
    return hit ? hit->t : 0;
  });
  print(name + ", pyramid", build, structure, exact, &exact);
  const Mesh mesh = unionMesh(images);
  std::unique_ptr<RayScene> embree;
  const double bvh = leastMilliseconds(runs, [&] { embree = std::make_unique<RayScene>(mesh); });
  print(name + ", Embree on its mesh", build, bvh, castAt(*embree, paths, runs), &exact);
  if (images.size() > 1) {
    return;
  }
  const std::vector<CameraMap> maps = cameraMaps(choice, reference, scene.cast, images);
  for (const double fine : {1.0, 0.5, 0.25}) {
    const SteppedImage stepped(images[0], maps[0], {.finePixels = fine});
    const Found found = castAll(paths, 1, [&](const RayPath& path, RayCost& cost) {
      const StraightRay ray{path[0], path[1] - path[0], 1};
      const auto meeting = stepped.meet(ray, cost);
      return meeting ? static_cast<float>(meeting->share) * path.tMax() : 0;
    });
    print(fmt::format("{}, steps of 6 and {:g}", name, fine), build, 0, found, &exact);
  }
}

void measure(const BenchChoice& choice, size_t triangles) {
  const std::string source =
      triangles > 0 ? fmt::format("builtin:mirror,triangles={}", triangles) : std::string("builtin:mirror");
  const ShadedScene scene = loadShadedScene(source, rolesFor(source, ""));
  const Box senders = boundsOf(scene.mirrors);
  const SecondaryRays rays = reflectedRays({scene, scene.mirrors}, PinholeCamera(pictureView(senders), 720, 480));
  const PinholeCamera reference(referenceView(scene.cast, senders, 720, 480), 720, 480);
  const glm::vec3 size = senders.size();
  const ViewCell cell{.sideRadii = std::max({size.x, size.y, size.z})};
  std::vector<RayPath> paths;
  for (const SecondaryRay& ray : rays.rays) {
    paths.push_back({ray.origin, ray.origin + ray.direction * 4.0f});
  }
  fmt::print("{}: {} cast triangles, {} reflected rays, {} threads\n", source, scene.cast.triangles.size(),
             paths.size(), threadCount());
  fmt::print("  {:<28} {:>9} {:>9} {:>9} {:>8} {:>7} {:>8} {:>9}\n", "", "build ms", "tree ms", "rays ms", "us/ray",
             "steps", "boxes", "same hit");
  std::unique_ptr<RayScene> geometry;
  const double bvh = leastMilliseconds(choice.runs, [&] { geometry = std::make_unique<RayScene>(scene.cast); });
  print("geometry, Embree", 0, bvh, castAt(*geometry, paths, choice.runs), nullptr);
  for (const std::string& camera : choice.cameras) {
    measureCamera(camera, scene, reference, cell, paths, choice.runs);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  ocelli::BenchChoice choice;
  CLI::App app("Rays at reference images, by pyramids, by steps, and by Embree");
  app.add_option("--triangles", choice.triangles, "of the scene; 0 leaves its teapots as they are")->delimiter(',');
  app.add_option("--cameras", choice.cameras, "of the reference images")->delimiter(',');
  app.add_option("--runs", choice.runs, "of which the best counts")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  for (const size_t triangles : choice.triangles) {
    ocelli::measure(choice, triangles);
  }
  return 0;
}
