// What is under the pointer: follows the rays of a camera, bent ones too, to the first thing that they meet.
#pragma once

#include <glm/vec2.hpp>
#include <memory>

#include "study/task/trial_layout.h"

namespace ocelli {

class RayScene;

class ObjectPicker {
 public:
  /// `scene` must outlive it.
  explicit ObjectPicker(const StudyScene& scene);
  ~ObjectPicker();
  ObjectPicker(const ObjectPicker&) = delete;
  ObjectPicker& operator=(const ObjectPicker&) = delete;

  /// Whether an object, moved by `offset`, shows at a pixel of the camera's image or within so many pixels of it. Walls
  /// hide it, other objects do not.
  bool isUnder(const StudyCamera& camera, const glm::dvec2& pixel, double tolerancePixels, size_t object,
               const glm::vec3& offset) const;

 private:
  bool isOnRay(const RayPath& path, size_t object, const glm::vec3& offset) const;

  const StudyScene& scene_;
  Mesh structure_;
  std::vector<std::vector<glm::uvec3>> triangles_;  ///< of each object, of the mesh of the scene
  std::unique_ptr<RayScene> walls_;
};

}  // namespace ocelli
