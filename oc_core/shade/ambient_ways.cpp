#include "oc_core/shade/ambient_ways.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <limits>
#include <optional>

#include "oc_core/ambient/free_space_target.h"
#include "oc_core/ambient/horizon_ambient.h"
#include "oc_core/ambient/ray_ambient.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/shade/effect.h"
#include "oc_core/shade/perspective_images.h"

namespace ocelli {
namespace {

using AmbientClock = std::chrono::steady_clock;

/// Rays at images begin above the surface: images from other viewpoints see it through pixels that are wider there, and
/// their surfaces between samples lie off it.
constexpr double kAmbientLiftFootprints = 2;
/// Viewpoints of occlusion cameras lie in a cell as wide as this share of the eye's distance from the scene's middle:
/// 31 degrees to each side.
constexpr float kAmbientCell = 1.2f;
constexpr uint64_t kTruthSeed = 1;
constexpr uint64_t kOtherSeed = 2;

double ambientMillisecondsSince(AmbientClock::time_point start) {
  return std::chrono::duration<double, std::milli>(AmbientClock::now() - start).count();
}

/// Fills in the light, and the least time of the runs.
void timeLight(AmbientLight& result, int runs, const std::function<std::vector<float>()>& find) {
  result.lightMilliseconds = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run) {
    const auto start = AmbientClock::now();
    result.light = find();
    result.lightMilliseconds = std::min(result.lightMilliseconds, ambientMillisecondsSince(start));
  }
}

double liftOf(const AmbientScene& scene) {
  return 1e-5 * static_cast<double>(glm::length(scene.bounds.size()));
}

PinholeCamera widerView(const AmbientInputs& in) {
  return withBorder(in.sight.camera, in.sight.camera.height() / 4);
}

GraphCamera threeFrustaOf(const AmbientInputs& in) {
  const PinholeCamera view = widerView(in);
  const glm::dvec3 direction(view.forward());
  const SplitCurve& curve = in.scene.curve;
  const glm::dvec3 split =
      in.settings.splitShare ? curve.pointAt(direction, *in.settings.splitShare) : curve.pointFor(direction);
  return threeFrusta(view, split, in.scene.bounds, {in.settings.turnDegrees});
}

size_t ambientSamplesOf(const FragmentImage& fragments) {
  size_t samples = 0;
  for (const Fragment& fragment : fragments) {
    samples += fragment.covered();
  }
  return samples;
}

HorizonImage horizonImage(const GraphCamera& camera, const AmbientInputs& in, AmbientLight& result) {
  const FragmentImage fragments = rasterize(camera, in.scene.mesh());
  result.samples += ambientSamplesOf(fragments);
  return {camera, fragments, in.scene.mesh()};
}

AmbientLight tracedLight(const AmbientInputs& in, int runs, int rays, uint64_t seed) {
  AmbientLight result;
  timeLight(result, runs, [&] {
    return ambientByRays(in.sight.points, in.scene.rays, in.scene.options,
                         {.count = rays, .seed = seed, .lift = liftOf(in.scene)});
  });
  return result;
}

AmbientLight horizonLight(const GraphCamera& camera, const AmbientInputs& in, int runs) {
  AmbientLight result;
  const auto start = AmbientClock::now();
  const HorizonImage image = horizonImage(camera, in, result);
  result.buildMilliseconds = ambientMillisecondsSince(start);
  timeLight(result, runs, [&] { return ambientByHorizon(in.sight.points, image, in.scene.options).light; });
  return result;
}

/// With the view's own image for points that the graph camera does not hold.
AmbientLight graphLight(const GraphCamera& camera, const AmbientInputs& in, int runs) {
  AmbientLight result;
  const auto start = AmbientClock::now();
  const HorizonImage image = horizonImage(camera, in, result);
  const HorizonImage plain = horizonImage(GraphCamera(widerView(in)), in, result);
  result.buildMilliseconds = ambientMillisecondsSince(start);
  timeLight(result, runs, [&] {
    std::vector<AmbientPoint> others;
    for (const AmbientPoint& point : in.sight.points) {
      if (!isHeld(point, camera)) {
        others.push_back(point);
      }
    }
    std::vector<float> found = ambientByHorizon(in.sight.points, image, in.scene.options).light;
    const std::vector<float> fallback = ambientByHorizon(others, plain, in.scene.options).light;
    for (size_t i = 0, k = 0; i < found.size() && k < others.size(); ++i) {
      if (in.sight.points[i].pixel == others[k].pixel) {
        found[i] = fallback[k++];
      }
    }
    return found;
  });
  return result;
}

AmbientLight ambientImageLight(const ReferenceImages& images, AmbientClock::time_point start, const AmbientInputs& in,
                               int runs) {
  AmbientLight result;
  for (const ReferenceImage& image : images) {
    result.samples += image.sampleCount();
  }
  const DepthImageTarget samples(images);
  const FreeSpaceTarget target(samples, in.sight.camera, in.sight.seen);
  result.buildMilliseconds = ambientMillisecondsSince(start);
  timeLight(result, runs, [&] {
    return ambientByRays(
        in.sight.points, target, in.scene.options,
        {.count = kImageRays, .seed = kOtherSeed, .liftFootprints = kAmbientLiftFootprints, .lift = liftOf(in.scene)});
  });
  return result;
}

/// The ways with a name of their own.
struct NamedWay {
  const char* name;
  AmbientLight (*light)(const AmbientInputs& in, int runs);
};

constexpr std::array<NamedWay, 5> kNamedWays{{
    {kTraced, [](const AmbientInputs& in, int runs) { return tracedLight(in, runs, kTruthRays, kTruthSeed); }},
    {"horizon", [](const AmbientInputs& in, int runs) { return horizonLight(GraphCamera(in.sight.camera), in, runs); }},
    {"horizon-wide",
     [](const AmbientInputs& in, int runs) { return horizonLight(GraphCamera(widerView(in)), in, runs); }},
    {"graph", [](const AmbientInputs& in, int runs) { return graphLight(threeFrustaOf(in), in, runs); }},
    {"graph-rays",
     [](const AmbientInputs& in, int runs) {
       const auto start = AmbientClock::now();
       const GraphCamera camera = threeFrustaOf(in);
       const FragmentImage fragments = rasterize(camera, in.scene.mesh());
       return ambientImageLight({placedImage(camera, fragments, in.scene.mesh(), camera.root().view(), "graph")}, start,
                                in, runs);
     }},
}};

const NamedWay* namedWay(const std::string& way) {
  for (const NamedWay& named : kNamedWays) {
    if (way == named.name) {
      return &named;
    }
  }
  return nullptr;
}

constexpr std::string_view kTracedPrefix = "traced-";
constexpr std::string_view kHorizonWord = ":horizon";

/// Of "traced-N".
std::optional<int> raysIn(const std::string& way) {
  if (!way.starts_with(kTracedPrefix)) {
    return std::nullopt;
  }
  const int rays = numberFromText<int>(std::string_view(way).substr(kTracedPrefix.size())).value_or(0);
  if (rays < 1 || rays > AmbientRays::kMaxRays) {
    throw InputError("\"" + way + "\" does not say how many rays", "--by",
                     "write traced-64; up to " + std::to_string(AmbientRays::kMaxRays));
  }
  return rays;
}

constexpr const char* kAmbientWays =
    "use traced, traced-N, horizon, horizon-wide, graph, graph-rays, a camera of `ocelli camera list`, or a file of "
    "one";

AmbientLight lightByImages(const std::string& way, const AmbientInputs& in, int runs) {
  const auto start = AmbientClock::now();
  const PinholeCamera reference = widerView(in);
  if (namesConstructor(way)) {
    const PerspectiveImage image = perspectiveImage(way, in.scene.shaded->whole, in.scene.mesh(), reference);
    return ambientImageLight({image.samples(in.scene.mesh(), way)}, start, in, runs);
  }
  ViewCell cell;
  const float distance = glm::distance(reference.eye(), in.scene.bounds.center());
  cell.sideRadii = in.settings.cellSide.value_or(std::max(kAmbientCell * distance, 1e-3f));
  return ambientImageLight(buildReferenceImages(cameraChoice(way, cell), reference, in.scene.mesh(), in.progress),
                           start, in, runs);
}

}  // namespace

AmbientLight ambientLightBy(const std::string& way, const AmbientInputs& inputs, int runs) {
  if (const NamedWay* named = namedWay(way)) {
    return named->light(inputs, runs);
  }
  if (const std::optional<int> rays = raysIn(way)) {
    return tracedLight(inputs, runs, *rays, kOtherSeed);
  }
  if (way.ends_with(kHorizonWord)) {
    const std::string name = way.substr(0, way.size() - kHorizonWord.size());
    const PerspectiveImage image =
        perspectiveImage(name, inputs.scene.shaded->whole, inputs.scene.mesh(), inputs.sight.camera);
    return graphLight(graphCameraOf(image, name), inputs, runs);
  }
  return lightByImages(way, inputs, runs);
}

std::vector<std::string> ambientWayNames() {
  std::vector<std::string> names;
  for (const NamedWay& named : kNamedWays) {
    if (named.name != std::string_view(kTraced)) {
      names.emplace_back(named.name);
    }
  }
  for (const CameraName& camera : cameraNames()) {
    if (cameraChoice(camera.name).hasImages()) {
      names.emplace_back(camera.name);
    }
  }
  return names;
}

void checkAmbientWay(const std::string& way) {
  if (namedWay(way) != nullptr || raysIn(way)) {
    return;
  }
  const bool isHorizon = way.ends_with(kHorizonWord);
  const std::string name = isHorizon ? way.substr(0, way.size() - kHorizonWord.size()) : way;
  if (namesConstructor(name)) {
    return;
  }
  if (isHorizon) {
    throw InputError("\"" + name + "\" is no graph camera", "--by " + way,
                     "use the name of a constructor of `ocelli camera list`, or its file");
  }
  if (!namesCamera(name)) {
    throw InputError("there is no \"" + name + "\" that tells what hides light", "--by", kAmbientWays);
  }
  if (!cameraChoice(name).hasImages()) {
    throw InputError("\"" + name + "\" is a mesh and has no image for rays to hit", "--by", kAmbientWays);
  }
}

}  // namespace ocelli
