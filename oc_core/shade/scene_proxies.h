// What stands for a scene where secondary rays go, and what they see of it: the geometry itself, an environment map, or
// the reference images of any camera.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/depth_rays/depth_ray_caster.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/shade/cast_objects.h"
#include "oc_core/shade/effect.h"
#include "oc_core/shade/secondary_rays.h"
#include "oc_core/shade/specular_ways.h"

namespace ocelli {

/// What a ray sees.
struct ProxyHit {
  glm::vec3 color{0};  ///< linear
  /// To the first hit of what depth images stand for, or of a billboard; nothing where the ray sees something else, or
  /// where nothing tells distances.
  std::optional<float> distance = {};
  bool onCast = false;  ///< whether that is of an object that depth images stand for
  /// A mirror among those, which sends the ray on.
  std::optional<MetMirror> mirror = {};
};

class SceneProxy {
 public:
  virtual ~SceneProxy() = default;
  /// `cost` grows by what it took in pyramids. Safe to call from many threads.
  virtual ProxyHit hit(const SecondaryRay& ray, RayCost& cost) const = 0;
  /// Whether the caster of ProxyInputs casts rays at it.
  virtual bool isOnDevice() const { return false; }
  /// The same as hit() for each of many rays, which that caster casts, with what each took. Where it is on the device;
  /// called by one thread at a time.
  virtual void hitsOnDevice(std::span<const SecondaryRay> rays, std::span<ProxyHit> found,
                            std::span<RayCost> costs) const;
};

struct ProxyInputs {
  const ShadedScene& scene;
  const CastObjects& cast;
  glm::vec3 viewpoint;             ///< of environment maps: the middle of what sends rays
  const PinholeCamera& reference;  ///< of reference images
  ViewCell cell;                   ///< that they are made for: what sends rays lies in it
  int environmentHeight = 1024;
  const Progress& progress;
  const DepthRayCaster* caster = nullptr;  ///< of rays at the pyramids of reference images; nullptr: the CPU
};

struct BuiltProxy {
  std::string name;
  std::unique_ptr<SceneProxy> proxy = {};
  double buildMilliseconds = 0;      ///< of images, or of the acceleration structure of the geometry
  double structureMilliseconds = 0;  ///< of cells and pyramid
  size_t samples = 0;                ///< of reference images
  size_t triangles = 0;              ///< that rays can hit
  bool hasDepth = true;              ///< whether it tells distances
};

inline constexpr const char* kEnvironment = "environment";

/// What `way.target` names is "traced" (the geometry, by ray casting), "environment" (an environment map of all), or a
/// camera, whose reference images of the cast objects are hit; an environment map shows what lies outside of them.
/// That may be a graph or curved ray camera too, by the name of its constructor or a JSON file (perspective_images.h).
/// Throws InputError for another name, for a representation without images, for images that cannot be met as the way
/// says, and where the images cannot be built.
BuiltProxy buildProxy(const SpecularWayName& way, const ProxyInputs& inputs);

/// Throws as specularWay() and buildProxy() do for a way that they do not take, as far as can be said beforehand.
void checkProxyName(const std::string& way);

}  // namespace ocelli
