#include "study/views/shown_objects.h"

#include <glm/vector_relational.hpp>

#include "oc_core/render/identity_image.h"

namespace ocelli {
namespace {

/// Of the box's height: what lies lower is the floor. Boxes are as much wider, as samples lie beside the surface by
/// rounding.
constexpr float kRimShare = 0.02f;

}  // namespace

ShownObjects::ShownObjects(const TrialLayout& layout) {
  for (size_t i = 0; i < layout.scene->objectCount(); ++i) {
    const glm::vec3 offset = i < layout.objectOffsets.size() ? layout.objectOffsets[i] : glm::vec3(0);
    Box box = layout.scene->boxOf(i);
    const float rim = kRimShare * (box.upper.y - box.lower.y);
    box.lower += offset + glm::vec3(-rim, rim, -rim);
    box.upper += offset + rim;
    boxes_.push_back(box);
  }
}

uint32_t ShownObjects::at(const glm::vec3& point) const {
  for (size_t i = 0; i < boxes_.size(); ++i) {
    if (glm::all(glm::greaterThanEqual(point, boxes_[i].lower)) &&
        glm::all(glm::lessThanEqual(point, boxes_[i].upper))) {
      return static_cast<uint32_t>(i + 1);
    }
  }
  return kStructure;
}

std::vector<uint32_t> ShownObjects::ofTriangles(const Mesh& mesh) const {
  std::vector<uint32_t> objects;
  objects.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    objects.push_back(
        at((mesh.positions[triangle.x] + mesh.positions[triangle.y] + mesh.positions[triangle.z]) / 3.0f));
  }
  return objects;
}

}  // namespace ocelli
