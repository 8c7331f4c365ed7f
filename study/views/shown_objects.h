// Which object of a scene a sample of its surface is of, where nothing but its place is known: samples of reference
// images, and triangles of their meshes.
#pragma once

#include <vector>

#include "study/task/trial_layout.h"

namespace ocelli {

/// A point belongs to the object whose box holds it, but for the box's lowest part, where the floor is.
class ShownObjects {
 public:
  explicit ShownObjects(const TrialLayout& layout);

  /// As StudyScene::objectOfTriangle().
  uint32_t at(const glm::vec3& point) const;
  /// Of each triangle, by its middle.
  std::vector<uint32_t> ofTriangles(const Mesh& mesh) const;

 private:
  std::vector<Box> boxes_;
};

}  // namespace ocelli
