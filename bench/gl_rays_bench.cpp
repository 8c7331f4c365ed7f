// Rays at reference images on the GPU: the pyramid's walk against the same on the CPU and against Embree on the
// geometry, with the reflected rays of `builtin:mirror`, in the same run; the whole picture with its mirror; and the
// text's steps on both.
//
// Times of the CPU are wall times of all threads; those of OpenGL end when the GPU has finished. "cast" is the walk of
// rays that are on the GPU and stay there; "list" also uploads the rays and reads back what they hit. The least of
// several runs counts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl_rays/gl_reflection.h"
#include "oc_core/gl_rays/gl_stepped_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/cast_representation.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/environment_map.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchChoice {
  std::vector<size_t> triangles{0, 300'000, 1'000'000};
  std::vector<std::string> cameras{"di", "spoc", "ddoc", "cell", "ldi-4"};
  std::string provider = "auto";
  std::string json;
  int runs = 3;
  int threads = 0;
  int width = 720;
  int height = 480;
};

constexpr int kEnvironmentHeight = 1024;

/// The scene and the rays that its mirror reflects.
struct Case {
  Case(const std::string& source, const BenchChoice& choice)
      : scene(loadShadedScene(source, rolesFor(source, ""))),
        senders(boundsOf(scene.mirrors)),
        surfaces(scene, scene.mirrors),
        camera(pictureView(senders), choice.width, choice.height),
        reference(referenceView(scene.cast, senders, choice.width, choice.height), choice.width, choice.height),
        rays(reflectedRays(surfaces, camera)),
        map(senders.center(), scene.surroundings, kEnvironmentHeight, shadeBackground()) {
    const glm::vec3 size = senders.size();
    cell.sideRadii = std::max({size.x, size.y, size.z});
    for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
      append(direct, *part);
    }
    for (const SpecularObject& mirror : scene.mirrors) {
      append(mirrors, mirror.mesh);
      normals.insert(normals.end(), mirror.normals.begin(), mirror.normals.end());
    }
    for (const SecondaryRay& ray : rays.rays) {
      paths.push_back({ray.origin, ray.origin + ray.direction * 4.0f});
      straight.push_back({ray.origin, paths.back()[1] - paths.back()[0], 1});
    }
  }

  ShadedScene scene;
  Box senders;
  FirstSurfaces surfaces;
  PinholeCamera camera;
  PinholeCamera reference;
  SecondaryRays rays;
  EnvironmentMap map;
  ViewCell cell;
  Mesh direct;
  Mesh mirrors;
  std::vector<glm::vec3> normals;
  std::vector<RayPath> paths;
  std::vector<StraightRay> straight;
};

template <class Target>
double castOnCpu(const Target& target, const std::vector<RayPath>& paths, int runs,
                 std::vector<std::optional<Hit>>& found) {
  constexpr size_t kGrain = 512;
  return leastMilliseconds(runs, [&] {
    parallelFor(paths.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        found[i] = target.hit(paths[i]);
      }
    });
  });
}

size_t differing(const std::vector<std::optional<Hit>>& a, const std::vector<std::optional<Hit>>& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    count += a[i].has_value() != b[i].has_value() || (a[i] && std::abs(a[i]->t - b[i]->t) > 1e-4f * a[i]->t);
  }
  return count;
}

Json measureCamera(GlContext& context, const std::string& name, const Case& c, double embree, int runs) {
  const GladGLContext& gl = context.gl();
  const ReferenceImages images = buildReferenceImages(cameraChoice(name, c.cell), c.reference, c.scene.cast);
  const DepthImageTarget target(images);
  std::vector<std::optional<Hit>> expected(c.paths.size());
  std::vector<std::optional<Hit>> found(c.paths.size());
  std::vector<RayCost> costs(c.paths.size());
  const double cpu = castOnCpu(target, c.paths, runs, expected);

  GlRayWalk walk(context, target);
  const double upload = leastMilliseconds(runs, [&] {
    walk.setTarget(target.cells(), target.pyramid());
    gl.Finish();
  });
  const GlRays onGpu(context, rayImage(c.straight));
  const double cast = leastMilliseconds(runs, [&] {
    walk.walk(onGpu);
    gl.Finish();
  });
  const double list = leastMilliseconds(runs, [&] { castOnGpu(context, walk, target, c.paths, found, costs); });
  RayCost cost;
  for (const RayCost& each : costs) {
    cost += each;
  }

  const GlReflection reflection(context, c.mirrors, c.normals,
                                {c.direct, target, c.scene.billboards, c.map.image(), shadeBackground()});
  const double picture = leastMilliseconds(runs, [&] {
    reflection.draw(c.camera);
    gl.Finish();
  });
  const Progress none;
  const CastObjects hittable = castObjects(c.scene, nullptr);
  const BuiltProxy built = buildProxy(
      specularWay(name), {c.scene, hittable, c.senders.center(), c.reference, c.cell, kEnvironmentHeight, none});
  const double pictureOnCpu =
      leastMilliseconds(runs, [&] { shade(reflectedRays(c.surfaces, c.camera), *built.proxy); });

  const auto rays = static_cast<double>(c.paths.size());
  const double off = static_cast<double>(differing(expected, found)) / rays;
  fmt::print(
      "  {:<10} {:>9} {:>7.1f} {:>9.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.3f} {:>9.1f} {:>9.1f} "
      "{:>7.2f}\n",
      name, target.cells().mesh.triangles.size(), static_cast<double>(cost.steps()) / rays, upload, cast, list, cpu,
      cast / cpu, cast / embree, 100 * off, picture, pictureOnCpu, picture / pictureOnCpu);
  std::fflush(stdout);
  return {{"camera", name},
          {"triangles", target.cells().mesh.triangles.size()},
          {"stepsPerRay", static_cast<double>(cost.steps()) / rays},
          {"uploadMs", upload},
          {"glCastMs", cast},
          {"glListMs", list},
          {"cpuCastMs", cpu},
          {"embreeCastMs", embree},
          {"glPerCpu", cast / cpu},
          {"glPerEmbree", cast / embree},
          {"differing", off},
          {"glPictureMs", picture},
          {"cpuPictureMs", pictureOnCpu}};
}

/// The text's steps along the same rays, at what a camera sees.
template <Camera C>
Json measureSteps(GlContext& context, const std::string& name, const C& camera, const Case& c, int runs) {
  const ReferenceImage image = placedImage(camera, c.scene.cast, RayScene(c.scene.cast), c.reference.view(), name);
  const CameraMap map = mapOf(camera);
  const SteppedImage stepped(image, map, {.finePixels = 0.25});
  std::vector<float> expected(c.straight.size());
  constexpr size_t kGrain = 512;
  const double cpu = leastMilliseconds(runs, [&] {
    parallelFor(c.straight.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        RayCost cost;
        const auto meeting = stepped.meet(c.straight[i], cost);
        expected[i] = meeting ? static_cast<float>(meeting->share) * glm::length(c.straight[i].step) : 0;
      }
    });
  });
  const Image<StraightRay> list = rayImage(c.straight);
  const GlRays onGpu(context, list);
  const GlSteppedImage walk(context, stepped, camera);
  const double cast = leastMilliseconds(runs, [&] {
    walk.walk(onGpu);
    context.gl().Finish();
  });
  const auto hits =
      readTexture<glm::vec4>(context, walk.walk(onGpu).hits, list.width(), list.height(), GL_RGBA, GL_FLOAT);
  size_t off = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    off += std::abs(hits[rayTexel(list, i)].x - expected[i]) > 1e-4f * std::max(expected[i], 1.0f);
  }
  const double differ = static_cast<double>(off) / static_cast<double>(expected.size());
  fmt::print("  {:<28} cast {:>8.2f} ms, CPU {:>8.2f} ms, ratio {:>5.2f}, differ {:.3f} %\n",
             name + ", steps of 6 and 1/4", cast, cpu, cast / cpu, 100 * differ);
  std::fflush(stdout);
  return {{"camera", name}, {"glCastMs", cast}, {"cpuCastMs", cpu}, {"glPerCpu", cast / cpu}, {"differing", differ}};
}

void measureRays(const BenchChoice& choice) {
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
  for (const size_t triangles : choice.triangles) {
    const std::string source =
        triangles > 0 ? fmt::format("builtin:mirror,triangles={}", triangles) : std::string("builtin:mirror");
    const Case c(source, choice);
    const RayScene geometry(c.scene.cast);
    std::vector<std::optional<Hit>> traced(c.paths.size());
    const double embree = castOnCpu(geometry, c.paths, choice.runs, traced);
    fmt::print("\n{}: {} cast triangles, {} reflected rays; Embree on the geometry {:.2f} ms\n", source,
               c.scene.cast.triangles.size(), c.paths.size(), embree);
    fmt::print("  {:<10} {:>9} {:>7} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9} {:>7}\n", "", "triangles",
               "steps", "upload ms", "cast ms", "list ms", "CPU ms", "per CPU", "/Embree", "differ %", "pict. ms",
               "CPU ms", "ratio");
    Json cameras = Json::array();
    for (const std::string& camera : choice.cameras) {
      cameras.push_back(measureCamera(*context, camera, c, embree, choice.runs));
    }
    const Json steps{measureSteps(*context, "di", c.reference, c, choice.runs),
                     measureSteps(*context, "spoc", buildSpocCamera(c.reference, c.scene.cast), c, choice.runs),
                     measureSteps(*context, "ddoc", buildDdocCamera(c.reference, c.scene.cast), c, choice.runs)};
    report["scenes"].push_back({{"scene", source},
                                {"castTriangles", c.scene.cast.triangles.size()},
                                {"rays", c.paths.size()},
                                {"cameras", cameras},
                                {"steps", steps}});
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, report.dump(2) + "\n");
  }
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Rays at reference images with OpenGL, on the CPU and by Embree.", "gl_rays_bench");
  BenchChoice choice;
  program.add_option("--triangles", choice.triangles, "Of the scene; 0 leaves its teapots as they are")
      ->delimiter(',')
      ->capture_default_str();
  program.add_option("--cameras", choice.cameras, "Of the reference images")->delimiter(',')->capture_default_str();
  program.add_option("--provider", choice.provider, "auto, egl or osmesa")->capture_default_str();
  addCommonOptions(program, choice);
  program.add_option("--json", choice.json, "Write the same figures to a file");
  return runProgram(program, argumentCount, arguments, choice, measureRays);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  return ocelli::run(argumentCount, arguments);
}
