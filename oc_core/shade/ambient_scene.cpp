#include "oc_core/shade/ambient_scene.h"

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {

AmbientScene::AmbientScene(std::shared_ptr<const ShadedScene> shadedScene, std::optional<double> radius)
    : shaded(std::move(shadedScene)), rays(mesh()), curve(mesh()), bounds(boundsOf(mesh())) {
  options.radius = radius.value_or(defaultRadius(bounds));
  const std::vector<uint32_t>& roles = shaded->rolesOfTriangle;
  allReceive = std::none_of(roles.begin(), roles.end(), [](uint32_t bits) { return (bits & kReceives) != 0; });
}

double AmbientScene::defaultRadius(const Box& bounds) {
  return bounds.empty() ? 0 : 0.15 * static_cast<double>(glm::length(bounds.size()));
}

bool AmbientScene::receives(uint32_t triangle) const {
  return allReceive || (shaded->rolesOfTriangle[triangle] & kReceives) != 0;
}

AmbientSight::AmbientSight(const AmbientScene& scene, const PinholeCamera& view)
    : camera(view), seen(raycast(view, scene.mesh(), scene.rays)) {
  points = ambientPoints(view, seen, scene.mesh(), [&](uint32_t triangle) { return scene.receives(triangle); });
}

}  // namespace ocelli
