#include "oc_core/shade/shadow_ways.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/shade/effect.h"
#include "oc_core/soft_shadows/light_backprojection.h"
#include "oc_core/soft_shadows/outline_visibility.h"
#include "oc_core/soft_shadows/percentage_closer.h"
#include "oc_core/soft_shadows/traced_visibility.h"

namespace ocelli {
namespace {

using ShadowClock = std::chrono::steady_clock;

constexpr const char* kKnownWays =
    "use traced, traced-N, outlines, pcss, backprojection, or a camera of `ocelli camera list`";
/// What receivers on sampled surfaces are moved by, in footprints of samples: measured on builtin:lamp, where less lets
/// squares of samples shade their own surface, and more lets light in where things touch.
constexpr float kLiftFootprints = 0.5f;
constexpr float kTowardsLightFootprints = 1;

double sinceShadowStart(ShadowClock::time_point start) {
  return std::chrono::duration<double, std::milli>(ShadowClock::now() - start).count();
}

ReceiverLift liftFor(const ShadowInputs& in) {
  ReceiverLift lift;
  lift.perDistance = kLiftFootprints / in.reference.focalPixels();
  lift.towardsLight = kTowardsLightFootprints / in.reference.focalPixels();
  return lift;
}

const AreaLight& lightOf(const ShadowInputs& in) {
  return in.scene.lights.front();
}

BuiltShadow tracedBy(int rays, const ShadowInputs& in) {
  BuiltShadow built;
  const auto start = ShadowClock::now();
  built.occluders = std::make_shared<const Mesh>(shadowOccluders(in.scene));
  built.visibility = std::make_unique<TracedVisibility>(*built.occluders, lightOf(in), rays);
  built.structureMilliseconds = sinceShadowStart(start);
  return built;
}

/// Outlines of a mesh.
void addOutlines(BuiltShadow& built, const Mesh& mesh, const ShadowInputs& in, const OutlineOptions& options) {
  const auto start = ShadowClock::now();
  auto visibility = std::make_unique<OutlineVisibility>(mesh, lightOf(in), options);
  built.structureMilliseconds = sinceShadowStart(start);
  built.edges = visibility->edgeCount();
  built.visibility = std::move(visibility);
}

BuiltShadow outlinesOfGeometry(const ShadowInputs& in) {
  BuiltShadow built;
  addOutlines(built, shadowOccluders(in.scene), in, {.gridSide = in.lightSide});
  return built;
}

BuiltShadow outlinesOfImages(const CameraChoice& choice, const ShadowInputs& in) {
  BuiltShadow built{.name = choice.name};
  const auto start = ShadowClock::now();
  ReferenceImages images = buildReferenceImages(choice, in.reference, in.scene.cast, in.progress);
  for (ReferenceImage& image : images) {
    image.seenFromAside = true;  // by receivers on the surfaces themselves
  }
  Mesh mesh = unionMesh(images);
  built.buildMilliseconds = sinceShadowStart(start);
  for (const ReferenceImage& image : images) {
    built.samples += image.sampleCount();
  }
  mesh.colors.clear();
  Mesh billboards = in.scene.billboards;
  billboards.colors.clear();
  append(mesh, billboards);
  addOutlines(built, mesh, in,
              {.gridSide = in.lightSide, .lift = liftFor(in), .footprintPerDistance = 1 / in.reference.focalPixels()});
  return built;
}

/// Of the plain shadow map, which shows billboards too.
template <class Shadows, class Options>
BuiltShadow byShadowMap(const ShadowInputs& in, const Options& options) {
  BuiltShadow built;
  const auto start = ShadowClock::now();
  const ReferenceImage image = buildDepthImage(in.reference, shadowOccluders(in.scene));
  built.buildMilliseconds = sinceShadowStart(start);
  const auto ready = ShadowClock::now();
  const LightShadowMap map(image, LightFrame(lightOf(in)));
  built.visibility = std::make_unique<Shadows>(map, lightOf(in), options);
  built.structureMilliseconds = sinceShadowStart(ready);
  built.samples = map.samples();
  return built;
}

BuiltShadow byPercentageCloser(const ShadowInputs& in) {
  return byShadowMap<PercentageCloserShadows>(
      in, PercentageCloserOptions{.searchTaps = in.lightSide / 2, .filterTaps = in.lightSide / 2, .lift = liftFor(in)});
}

BuiltShadow byBackprojection(const ShadowInputs& in) {
  return byShadowMap<BackprojectedShadows>(in, BackprojectionOptions{.gridSide = in.lightSide, .lift = liftFor(in)});
}

struct NamedShadow {
  const char* name;
  BuiltShadow (*build)(const ShadowInputs&);
};

constexpr NamedShadow kNamedShadows[] = {
    {kTraced, [](const ShadowInputs& in) { return tracedBy(kTracedShadowRays, in); }},
    {"outlines", outlinesOfGeometry},
    {"pcss", byPercentageCloser},
    {"backprojection", byBackprojection},
};

/// The N of "traced-N"; nothing for other names.
std::optional<int> raysOfName(const std::string& name) {
  const std::string prefix = std::string(kTraced) + "-";
  if (!name.starts_with(prefix)) {
    return std::nullopt;
  }
  const int rays = numberFromText<int>(std::string_view(name).substr(prefix.size())).value_or(0);
  if (rays < 1 || rays > TracedVisibility::kMaxRays) {
    throw InputError("\"" + name + "\" has no number of rays from 1 to " + std::to_string(TracedVisibility::kMaxRays),
                     "--by", "for example traced-64");
  }
  return rays;
}

CameraChoice cameraOfName(const std::string& name, const ViewCell& cell) {
  if (!namesCamera(name)) {
    throw InputError("there is no way \"" + name + "\" to soft shadows", "--by", kKnownWays);
  }
  const CameraChoice choice = cameraChoice(name, cell);
  if (!choice.hasImages()) {
    throw InputError("\"" + name + "\" is a mesh and has no image", "--by", kKnownWays);
  }
  return choice;
}

}  // namespace

Mesh shadowOccluders(const ShadedScene& scene) {
  Mesh mesh;
  append(mesh, scene.cast);
  append(mesh, scene.billboards);
  return mesh;
}

void checkShadowName(const std::string& name) {
  for (const NamedShadow& way : kNamedShadows) {
    if (name == way.name) {
      return;
    }
  }
  if (!raysOfName(name)) {
    cameraOfName(name, {});
  }
}

std::vector<std::string> shadowNames() {
  std::vector<std::string> names;
  for (const NamedShadow& way : kNamedShadows) {
    if (std::string_view(way.name) != kTraced) {
      names.emplace_back(way.name);
    }
  }
  const std::vector<std::string> cameras = camerasWithImages();
  names.insert(names.end(), cameras.begin(), cameras.end());
  return names;
}

BuiltShadow buildShadow(const std::string& name, const ShadowInputs& in) {
  BuiltShadow built;
  const auto named = std::find_if(std::begin(kNamedShadows), std::end(kNamedShadows),
                                  [&](const NamedShadow& way) { return name == way.name; });
  if (named != std::end(kNamedShadows)) {
    built = named->build(in);
  } else if (const std::optional<int> rays = raysOfName(name)) {
    built = tracedBy(*rays, in);
  } else {
    built = outlinesOfImages(cameraOfName(name, in.cell), in);
  }
  built.name = built.name.empty() ? name : built.name;
  return built;
}

}  // namespace ocelli
