#include "oc_core/shade/secondary_rays.h"

#include <algorithm>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/shade/vertex_normals.h"

namespace ocelli {
namespace {

constexpr int kMaxInnerReflections = 4;
/// What a ray inside of glass begins before the surface that it comes from, of the size of the object.
constexpr float kStepInside = 1e-5f;

SecondaryRay throughGlass(const FirstSurfaces& surfaces, const SpecularObject& glass, const Fragment& entry,
                          const glm::vec3& incoming) {
  const auto index = static_cast<float>(glass.refractiveIndex);
  const glm::vec3 size = boundsOf(glass.mesh).size();
  const float step = kStepInside * glm::length(size);
  glm::vec3 place = positionOf(entry, glass.mesh);
  glm::vec3 direction = glm::refract(incoming, normalAt(entry, glass.mesh, glass.normals, incoming), 1 / index);
  for (int i = 0; i <= kMaxInnerReflections; ++i) {
    const glm::vec3 from = place + direction * step;
    const Fragment exit = surfaces.raysOf(glass).intersect({from, from + direction * (4 * glm::length(size))});
    if (!exit.covered()) {
      break;  // it is open there, or no thicker than the step
    }
    place = positionOf(exit, glass.mesh);
    const glm::vec3 normal = normalAt(exit, glass.mesh, glass.normals, direction);
    const glm::vec3 out = glm::refract(direction, normal, index);
    if (out != glm::vec3(0)) {
      return {place, glm::normalize(out)};
    }
    direction = glm::normalize(glm::reflect(direction, normal));
  }
  return {place, glm::normalize(direction)};
}

}  // namespace

SecondaryRays raysGoingOn(const FirstSurfaces& surfaces, const PinholeCamera& camera, const GoOn& goOn) {
  SecondaryRays result{Image<glm::vec3>(camera.width(), camera.height()), {}};
  std::vector<std::optional<SecondaryRay>> rayOf(result.base.size());
  parallelFor(static_cast<size_t>(camera.height()), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < camera.width(); ++x) {
        const RayPath path = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const FirstSurface first = surfaces.along(path);
        result.base(x, y) = first.color;
        if (first.object != nullptr) {
          SecondaryRay ray = goOn({*first.object, first.fragment, glm::normalize(path.back() - path.front()), {x, y}});
          ray.pixel = static_cast<uint32_t>(result.base.index(x, y));
          ray.sender = static_cast<uint32_t>(surfaces.numberOf(*first.object));
          rayOf[ray.pixel] = ray;
        }
      }
    }
  });
  for (const std::optional<SecondaryRay>& ray : rayOf) {
    if (ray) {
      result.rays.push_back(*ray);
    }
  }
  return result;
}

SecondaryRays reflectedRays(const FirstSurfaces& surfaces, const PinholeCamera& camera) {
  return raysGoingOn(surfaces, camera, [](const SpecularHit& hit) {
    const glm::vec3 normal = normalAt(hit.fragment, hit.object.mesh, hit.object.normals, hit.incoming);
    return SecondaryRay{positionOf(hit.fragment, hit.object.mesh), glm::normalize(glm::reflect(hit.incoming, normal))};
  });
}

SecondaryRays refractedRays(const FirstSurfaces& surfaces, const PinholeCamera& camera) {
  return raysGoingOn(surfaces, camera, [&](const SpecularHit& hit) {
    return throughGlass(surfaces, hit.object, hit.fragment, hit.incoming);
  });
}

}  // namespace ocelli
