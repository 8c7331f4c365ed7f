#include "oc_core/shade/scene_proxies.h"

#include <chrono>

#include "oc_core/base/error.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/environment_map.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Mesh together(std::initializer_list<const Mesh*> parts) {
  Mesh mesh;
  for (const Mesh* part : parts) {
    append(mesh, *part);
  }
  return mesh;
}

/// Long enough to reach everything from anywhere within.
float reachOf(const ShadedScene& scene) {
  Box box = boundsOf(scene.mirrors);
  const Box lenses = boundsOf(scene.lenses);
  for (const Box& other : {lenses, boundsOf(scene.cast), boundsOf(scene.billboards), boundsOf(scene.surroundings)}) {
    if (!other.empty()) {
      box.add(other.lower);
      box.add(other.upper);
    }
  }
  return 1.01f * glm::length(box.size());
}

RayPath pathOf(const SecondaryRay& ray, float reach) {
  return {ray.origin, ray.origin + ray.direction * reach};
}

/// The geometry itself: the truth.
class TracedProxy final : public SceneProxy {
 public:
  explicit TracedProxy(const ShadedScene& scene)
      : mesh_(together({&scene.cast, &scene.billboards, &scene.surroundings})),
        rays_(mesh_),
        castTriangles_(scene.cast.triangles.size()),
        reach_(reachOf(scene)) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost&) const override {
    const std::optional<Hit> hit = rays_.hit(pathOf(ray, reach_));
    return hit ? ProxyHit{hit->color, hit->t, hit->element < castTriangles_} : ProxyHit{shadeBackground(), {}, false};
  }
  size_t triangles() const { return mesh_.triangles.size(); }

 private:
  Mesh mesh_;
  RayScene rays_;
  size_t castTriangles_;
  float reach_;
};

class EnvironmentProxy final : public SceneProxy {
 public:
  explicit EnvironmentProxy(const ProxyInputs& in)
      : map_(in.viewpoint, together({&in.scene.cast, &in.scene.billboards, &in.scene.surroundings}),
             in.environmentHeight, shadeBackground()) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost&) const override { return {map_.colorOf(ray.direction), {}, false}; }
  bool hasDepth() const override { return false; }

 private:
  EnvironmentMap map_;
};

/// Reference images of the cast objects, billboards as they are, and an environment map of the rest.
class DepthImageProxy final : public SceneProxy {
 public:
  DepthImageProxy(const ProxyInputs& in, const ReferenceImages& images)
      : target_(images),
        billboards_(in.scene.billboards),
        map_(in.viewpoint, in.scene.surroundings, in.environmentHeight, shadeBackground()),
        reach_(reachOf(in.scene)) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost& cost) const override {
    const RayPath path = pathOf(ray, reach_);
    const std::optional<Hit> hit = target_.hit(path, cost);
    const std::optional<Hit> billboard = billboards_.hit(path);
    if (hit && (!billboard || hit->t <= billboard->t)) {
      return {hit->color, hit->t, true};
    }
    return billboard ? ProxyHit{billboard->color, billboard->t, false}
                     : ProxyHit{map_.colorOf(ray.direction), {}, false};
  }
  const DepthImageTarget& target() const { return target_; }

 private:
  DepthImageTarget target_;
  RayScene billboards_;
  EnvironmentMap map_;
  float reach_;
};

BuiltProxy buildTraced(const ProxyInputs& in) {
  BuiltProxy built{.name = kTraced};
  const auto start = Clock::now();
  auto proxy = std::make_unique<TracedProxy>(in.scene);
  built.buildMilliseconds = millisecondsSince(start);
  built.triangles = proxy->triangles();
  built.proxy = std::move(proxy);
  return built;
}

BuiltProxy buildEnvironment(const ProxyInputs& in) {
  BuiltProxy built{.name = kEnvironment};
  const auto start = Clock::now();
  built.proxy = std::make_unique<EnvironmentProxy>(in);
  built.buildMilliseconds = millisecondsSince(start);
  built.samples = 2 * static_cast<size_t>(in.environmentHeight) * static_cast<size_t>(in.environmentHeight);
  return built;
}

BuiltProxy buildDepthImages(const CameraChoice& choice, const ProxyInputs& in) {
  BuiltProxy built{.name = choice.name};
  const auto start = Clock::now();
  const ReferenceImages images = buildReferenceImages(choice, in.reference, in.scene.cast, in.progress);
  built.buildMilliseconds = millisecondsSince(start);
  for (const ReferenceImage& image : images) {
    built.samples += image.sampleCount();
  }
  const auto ready = Clock::now();
  // Its environment map and billboards are those of every other camera: their time is no part of this one's.
  static_cast<void>(DepthImageTarget(images));
  built.structureMilliseconds = millisecondsSince(ready);
  auto proxy = std::make_unique<DepthImageProxy>(in, images);
  built.triangles = proxy->target().cells().mesh.triangles.size();
  built.proxy = std::move(proxy);
  return built;
}

CameraChoice choiceOf(const std::string& name, const ViewCell& cell) {
  if (!name.ends_with(".json") && !findRepresentation(name)) {
    throw InputError("there is no \"" + name + "\" for rays to hit", "--by",
                     "use traced, environment, or a camera of `ocelli camera list`");
  }
  const CameraChoice choice = cameraChoice(name, cell);
  if (!choice.hasImages()) {
    throw InputError("\"" + name + "\" is a mesh and has no image for rays to hit", "--by",
                     "use traced, environment, or a camera of `ocelli camera list`");
  }
  return choice;
}

}  // namespace

void checkProxyName(const std::string& name) {
  if (name != kTraced && name != kEnvironment) {
    choiceOf(name, {});
  }
}

std::vector<std::string> proxyNames() {
  std::vector<std::string> names{kEnvironment};
  for (const CameraName& camera : cameraNames()) {
    if (cameraChoice(camera.name).hasImages()) {
      names.emplace_back(camera.name);
    }
  }
  return names;
}

BuiltProxy buildProxy(const std::string& name, const ProxyInputs& inputs) {
  if (name == kTraced) {
    return buildTraced(inputs);
  }
  return name == kEnvironment ? buildEnvironment(inputs) : buildDepthImages(choiceOf(name, inputs.cell), inputs);
}

}  // namespace ocelli
