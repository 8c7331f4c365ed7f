#include "oc_core/shade/first_surfaces.h"

#include "oc_core/image/color.h"

namespace ocelli {

glm::vec3 shadeBackground() {
  return linearFromSrgb(glm::vec3(0.80f, 0.88f, 0.95f));
}

FirstSurfaces::FirstSurfaces(const ShadedScene& scene, const std::vector<SpecularObject>& objects) : objects_(objects) {
  for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
    append(rest_, *part);
  }
  for (const std::vector<SpecularObject>* all : {&scene.mirrors, &scene.lenses}) {
    for (const SpecularObject& object : *all) {
      if (all != &objects) {
        append(rest_, object.mesh);
      }
    }
  }
  restRays_ = std::make_unique<RayScene>(rest_);
  for (const SpecularObject& object : objects) {
    objectRays_.push_back(std::make_unique<RayScene>(object.mesh));
  }
}

FirstSurface FirstSurfaces::along(const RayPath& ray) const {
  FirstSurface first{nullptr, restRays_->intersect(ray), shadeBackground()};
  if (first.fragment.covered()) {
    first.color = colorOf(first.fragment, rest_);
  }
  for (size_t i = 0; i < objects_.size(); ++i) {
    const Fragment fragment = objectRays_[i]->intersect(ray);
    if (fragment.covered() && (!first.fragment.covered() || fragment.t < first.fragment.t)) {
      first = {&objects_[i], fragment, glm::vec3(0)};
    }
  }
  return first;
}

}  // namespace ocelli
