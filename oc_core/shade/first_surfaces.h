// What a picture shows first, pixel by pixel: an object that sends rays on, or anything else. Made once for a scene,
// for pictures from anywhere.
#pragma once

#include <memory>
#include <vector>

#include "oc_core/render/raycast.h"
#include "oc_core/shade/shaded_scene.h"

namespace ocelli {

/// What is behind everything, linear.
glm::vec3 shadeBackground();

struct FirstSurface {
  const SpecularObject* object = nullptr;  ///< nothing: something else
  Fragment fragment;                       ///< of the object
  glm::vec3 color{0};                      ///< of something else, linear
};

class FirstSurfaces {
 public:
  /// `objects` send rays on: scene.mirrors or scene.lenses; those of the other kind are seen as they are. The scene
  /// must outlive this.
  FirstSurfaces(const ShadedScene& scene, const std::vector<SpecularObject>& objects);
  /// It stays where it is: rays refer to its meshes.
  FirstSurfaces(const FirstSurfaces&) = delete;
  FirstSurfaces& operator=(const FirstSurfaces&) = delete;

  FirstSurface along(const RayPath& ray) const;
  /// The number of one of the objects.
  size_t numberOf(const SpecularObject& object) const { return static_cast<size_t>(&object - objects_.data()); }
  /// Rays at one of the objects alone.
  const RayScene& raysOf(const SpecularObject& object) const { return *objectRays_[numberOf(object)]; }

 private:
  const std::vector<SpecularObject>& objects_;
  Mesh rest_;
  std::unique_ptr<RayScene> restRays_;
  std::vector<std::unique_ptr<RayScene>> objectRays_;
};

}  // namespace ocelli
