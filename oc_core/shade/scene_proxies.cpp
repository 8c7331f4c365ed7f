#include "oc_core/shade/scene_proxies.h"

#include <chrono>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/depth_rays/graph_image_target.h"
#include "oc_core/depth_rays/rim_cells.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/raycast.h"
#include "oc_core/shade/environment_map.h"
#include "oc_core/shade/first_surfaces.h"
#include "oc_core/shade/perspective_images.h"
#include "oc_core/shade/stepped_proxy.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kRaysATask = 512;

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

/// What vertices have, at a point of a triangle.
glm::vec3 interpolatedAt(const glm::vec3& point, const Mesh& mesh, uint32_t triangle,
                         const std::vector<glm::vec3>& ofVertex) {
  const glm::uvec3& t = mesh.triangles[triangle];
  const glm::vec3& a = mesh.positions[t.x];
  const glm::vec3& b = mesh.positions[t.y];
  const glm::vec3& c = mesh.positions[t.z];
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float area = glm::dot(normal, normal);
  if (!(area > 0)) {
    return ofVertex[t.x];
  }
  const float atB = glm::dot(normal, glm::cross(point - a, c - a)) / area;
  const float atC = glm::dot(normal, glm::cross(b - a, point - a)) / area;
  return ofVertex[t.x] * (1 - atB - atC) + ofVertex[t.y] * atB + ofVertex[t.z] * atC;
}

/// The geometry itself: the truth.
class TracedProxy final : public SceneProxy {
 public:
  explicit TracedProxy(const ProxyInputs& in)
      : mesh_(together({in.cast.mesh.get(), &in.scene.billboards, &in.scene.surroundings})),
        mirrorNormals_(in.cast.mirrorNormals),
        rays_(mesh_),
        castTriangles_(in.cast.mesh->triangles.size()),
        reach_(reachOf(in.scene)) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost&) const override {
    const std::optional<Hit> hit = rays_.hit(pathOf(ray, reach_));
    if (!hit) {
      return {shadeBackground(), {}, false};
    }
    ProxyHit seen{hit->color, hit->t, hit->element < castTriangles_};
    if (seen.onCast && !mirrorNormals_.empty()) {
      seen.mirror = metMirror(interpolatedAt(hit->position, mesh_, hit->element, mirrorNormals_));
    }
    return seen;
  }
  size_t triangles() const { return mesh_.triangles.size(); }

 private:
  Mesh mesh_;
  std::vector<glm::vec3> mirrorNormals_;
  RayScene rays_;
  size_t castTriangles_;
  float reach_;
};

class EnvironmentProxy final : public SceneProxy {
 public:
  explicit EnvironmentProxy(const ProxyInputs& in)
      : map_(in.viewpoint, together({in.cast.mesh.get(), &in.scene.billboards, &in.scene.surroundings}),
             in.environmentHeight, shadeBackground()) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost&) const override { return {map_.colorOf(ray.direction), {}, false}; }

 private:
  EnvironmentMap map_;
};

/// What is seen beside and behind depth images: billboards as they are, and an environment map of the rest.
class BesideImages {
 public:
  explicit BesideImages(const ProxyInputs& in)
      : billboards_(in.scene.billboards),
        map_(in.viewpoint, in.scene.surroundings, in.environmentHeight, shadeBackground()) {}

  ProxyHit hit(const SecondaryRay& ray, const RayPath& path) const {
    const std::optional<Hit> billboard = billboards_.hit(path);
    return billboard ? ProxyHit{billboard->color, billboard->t} : ProxyHit{map_.colorOf(ray.direction)};
  }

 private:
  RayScene billboards_;
  EnvironmentMap map_;
};

/// Reference images of the cast objects; with mirror normals in the place of colours where some of them mirror.
struct ProxyImages {
  ReferenceImages images;
  ReferenceImages normals = {};
};

bool comesBefore(float distance, const ProxyHit& other) {
  return !other.distance || distance <= *other.distance;
}

/// The surfaces between samples, through their pyramid.
class DepthImageProxy final : public SceneProxy {
 public:
  DepthImageProxy(const ProxyInputs& in, SampleCells cells, std::vector<glm::vec3> mirrorNormals)
      : target_(DepthImageTarget::ofCells(std::move(cells))),
        mirrorNormals_(std::move(mirrorNormals)),
        beside_(in),
        reach_(reachOf(in.scene)),
        onDevice_(in.caster != nullptr ? in.caster->prepare(target_) : nullptr) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost& cost) const override {
    const RayPath path = pathOf(ray, reach_);
    return seenBy(ray, path, target_.hit(path, cost));
  }
  bool isOnDevice() const override { return onDevice_ != nullptr; }
  void hitsOnDevice(std::span<const SecondaryRay> rays, std::span<ProxyHit> found,
                    std::span<RayCost> costs) const override {
    std::vector<RayPath> paths(rays.size());
    std::vector<std::optional<Hit>> hits(rays.size());
    parallelFor(rays.size(), kRaysATask, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        paths[i] = pathOf(rays[i], reach_);
      }
    });
    onDevice_->hits(paths, hits, costs);
    parallelFor(rays.size(), kRaysATask, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        found[i] = seenBy(rays[i], paths[i], hits[i]);
      }
    });
  }

 private:
  ProxyHit seenBy(const SecondaryRay& ray, const RayPath& path, const std::optional<Hit>& hit) const {
    ProxyHit beside = beside_.hit(ray, path);
    if (!hit || !comesBefore(hit->t, beside)) {
      return beside;
    }
    ProxyHit seen{hit->color, hit->t, true};
    if (!mirrorNormals_.empty()) {
      seen.mirror = metMirror(interpolatedAt(hit->position, target_.cells().mesh, hit->element, mirrorNormals_));
    }
    return seen;
  }

  DepthImageTarget target_;
  std::vector<glm::vec3> mirrorNormals_;  ///< of the vertices of its cells; none where nothing mirrors
  BesideImages beside_;
  float reach_;
  std::unique_ptr<DepthRayCaster::Target> onDevice_;
};

/// The same by steps along projections; what is behind shows through silhouettes.
class SteppedProxy final : public SceneProxy {
 public:
  SteppedProxy(const ProxyInputs& in, ProxyImages images, const CameraChoice& choice, double finePixels)
      : target_(choice, in.reference, *in.cast.mesh, std::move(images.images), finePixels, in.progress),
        normals_(std::move(images.normals)),
        beside_(in),
        reach_(reachOf(in.scene)) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost& cost) const override {
    const std::optional<SteppedHit> hit = target_.hit(ray.origin, ray.direction * reach_, cost);
    ProxyHit beside = beside_.hit(ray, pathOf(ray, reach_));
    if (!hit || !comesBefore(hit->distance, beside)) {
      return beside;
    }
    ProxyHit seen{glm::mix(beside.color, hit->color, hit->opacity), hit->distance, true};
    if (!normals_.empty()) {
      seen.mirror = metMirror(colorAround(normals_[0], hit->place));
    }
    return seen;
  }

 private:
  SteppedTarget target_;
  ReferenceImages normals_;
  BesideImages beside_;
  float reach_;
};

/// Frustum by frustum through the image of a graph camera.
class FrustaProxy final : public SceneProxy {
 public:
  FrustaProxy(const ProxyInputs& in, GraphImageTarget target, ReferenceImages normals)
      : target_(std::move(target)), normals_(std::move(normals)), beside_(in), reach_(reachOf(in.scene)) {}

  ProxyHit hit(const SecondaryRay& ray, RayCost& cost) const override {
    const RayPath path = pathOf(ray, reach_);
    const std::optional<Hit> hit = target_.hit(path, cost);
    ProxyHit beside = beside_.hit(ray, path);
    if (!hit || !comesBefore(hit->t, beside)) {
      return beside;
    }
    ProxyHit seen{hit->color, hit->t, true};
    if (!normals_.empty()) {
      seen.mirror = metMirror(normals_[0].color[hit->element]);
    }
    return seen;
  }
  const GraphImageTarget& target() const { return target_; }

 private:
  GraphImageTarget target_;
  ReferenceImages normals_;
  BesideImages beside_;
  float reach_;
};

BuiltProxy buildTraced(const ProxyInputs& in) {
  BuiltProxy built{.name = kTraced};
  const auto start = Clock::now();
  auto proxy = std::make_unique<TracedProxy>(in);
  built.buildMilliseconds = millisecondsSince(start);
  built.triangles = proxy->triangles();
  built.proxy = std::move(proxy);
  return built;
}

BuiltProxy buildEnvironment(const ProxyInputs& in) {
  BuiltProxy built{.name = kEnvironment, .hasDepth = false};
  const auto start = Clock::now();
  built.proxy = std::make_unique<EnvironmentProxy>(in);
  built.buildMilliseconds = millisecondsSince(start);
  built.samples = 2 * static_cast<size_t>(in.environmentHeight) * static_cast<size_t>(in.environmentHeight);
  return built;
}

/// What rays meet of images.
struct HitSurfaces {
  SampleCells cells;
  std::vector<glm::vec3> mirrorNormals;
  size_t rims = 0;
};

HitSurfaces surfacesOf(const ProxyImages& images) {
  return {sampleCells(images.images),
          images.normals.empty() ? std::vector<glm::vec3>() : unionMesh(images.normals).colors};
}

HitSurfaces surfacesToRims(const CameraChoice& choice, const ProxyImages& images, const ProxyInputs& in) {
  if (!canHaveRims(images.images) || choice.kind->maps == nullptr) {
    throw InputError("the images of \"" + choice.name + "\" have no rims between their samples", "--by",
                     "take a camera of one image that displaces a pinhole's, such as di, ddoc or cell, or leave "
                     "\"rims\" away");
  }
  const std::vector<CameraMap> maps = cameraMaps(choice, in.reference, *in.cast.mesh, images.images, in.progress);
  const RayScene geometry(*in.cast.mesh, RayScene::Quality::kLow);
  RimCells rims = rimCells(images.images[0], maps[0].ray, geometry);
  HitSurfaces surfaces{std::move(rims.cells), {}, rims.rims};
  for (const uint32_t pixel : rims.pixelOfVertex) {
    if (!images.normals.empty()) {
      surfaces.mirrorNormals.push_back(images.normals[0].color[pixel]);
    }
  }
  return surfaces;
}

/// The surfaces were begun at `start`.
void addPyramid(BuiltProxy& built, const ProxyInputs& in, HitSurfaces surfaces, Clock::time_point start) {
  // Environment maps and billboards are those of every other camera: their time is no part of this one's.
  static_cast<void>(SamplePyramid(surfaces.cells));
  built.structureMilliseconds = millisecondsSince(start);
  built.triangles = surfaces.cells.mesh.triangles.size();
  built.proxy = std::make_unique<DepthImageProxy>(in, std::move(surfaces.cells), std::move(surfaces.mirrorNormals));
}

BuiltProxy buildDepthImages(const CameraChoice& choice, const SpecularWayName& way, const ProxyInputs& in) {
  BuiltProxy built{.name = way.full};
  const auto start = Clock::now();
  ProxyImages images{buildReferenceImages(choice, in.reference, *in.cast.mesh, in.progress)};
  if (!in.cast.mirrorNormals.empty()) {
    Mesh coded = *in.cast.mesh;
    coded.colors = in.cast.mirrorNormals;
    images.normals = buildReferenceImages(choice, in.reference, coded, in.progress);
  }
  built.buildMilliseconds = millisecondsSince(start);
  for (const ReferenceImage& image : images.images) {
    built.samples += image.sampleCount();
  }
  if (way.isStepped()) {
    built.proxy = std::make_unique<SteppedProxy>(in, std::move(images), choice, way.finePixels);
    return built;
  }
  const auto ready = Clock::now();
  HitSurfaces surfaces = way.rims ? surfacesToRims(choice, images, in) : surfacesOf(images);
  built.samples += surfaces.rims;
  addPyramid(built, in, std::move(surfaces), ready);
  return built;
}

/// Of a graph or curved ray camera.
BuiltProxy buildPerspective(const SpecularWayName& way, const ProxyInputs& in) {
  BuiltProxy built{.name = way.full};
  const auto start = Clock::now();
  const Mesh& mesh = *in.cast.mesh;
  const PerspectiveImage image = perspectiveImage(way.target, in.scene.whole, mesh, in.reference);
  ProxyImages images;
  if (!in.cast.mirrorNormals.empty()) {
    Mesh coded = mesh;
    coded.colors = in.cast.mirrorNormals;
    images.normals = {image.samples(coded, way.target)};
  }
  if (way.byFrusta) {
    const GraphCamera& camera = graphCameraOf(image, way.target);
    const Box bounds = boundsOf(mesh);
    checkDisjoint(camera, glm::dvec3(bounds.lower), glm::dvec3(bounds.upper));
    built.buildMilliseconds = millisecondsSince(start);
    const auto ready = Clock::now();
    GraphImageTarget target(camera, image.fragments, mesh, {.thickness = graphThickness(bounds)});
    built.structureMilliseconds = millisecondsSince(ready);
    built.samples = target.sampleCount();
    built.proxy = std::make_unique<FrustaProxy>(in, std::move(target), std::move(images.normals));
    return built;
  }
  images.images = {image.samples(mesh, way.target)};
  built.buildMilliseconds = millisecondsSince(start);
  built.samples = images.images[0].sampleCount();
  const auto ready = Clock::now();
  addPyramid(built, in, surfacesOf(images), ready);
  return built;
}

/// Throws where the name is that of a camera which is not met so.
void checkPerspective(const SpecularWayName& way) {
  const bool isPerspective = namesConstructor(way.target);
  if (way.byFrusta && !isPerspective) {
    throw InputError("\"" + way.target + "\" is no graph camera, and has no frusta", "--by " + way.full,
                     "use the name of a constructor of `ocelli camera list`, or its file");
  }
  if (isPerspective && (way.isStepped() || way.rims)) {
    throw InputError("\"" + way.target + "\" is not walked by steps along projections, and has no rims",
                     "--by " + way.full, "write :by-frusta behind its name, or the name alone");
  }
}

CameraChoice choiceOf(const std::string& name, const ViewCell& cell) {
  if (!namesCamera(name)) {
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

void SceneProxy::hitsOnDevice(std::span<const SecondaryRay> /*rays*/, std::span<ProxyHit> /*found*/,
                              std::span<RayCost> /*costs*/) const {
  OC_CHECK(false, "it is not on a device");
}

void checkProxyName(const std::string& text) {
  const SpecularWayName way = specularWay(text);
  if (way.target == kTraced || way.target == kEnvironment) {
    return;
  }
  checkPerspective(way);
  if (!namesConstructor(way.target)) {
    choiceOf(way.target, {});
  }
}

std::vector<std::string> proxyNames() {
  std::vector<std::string> names = camerasWithImages();
  names.insert(names.begin(), kEnvironment);
  return names;
}

BuiltProxy buildProxy(const SpecularWayName& way, const ProxyInputs& inputs) {
  if (way.target != kTraced && way.target != kEnvironment) {
    checkPerspective(way);
    if (namesConstructor(way.target)) {
      return buildPerspective(way, inputs);
    }
    return buildDepthImages(choiceOf(way.target, inputs.cell), way, inputs);
  }
  BuiltProxy built = way.target == kTraced ? buildTraced(inputs) : buildEnvironment(inputs);
  built.name = way.full;
  return built;
}

}  // namespace ocelli
