#include "oc_core/scene/object_boxes.h"

#include <glm/common.hpp>

#include "oc_core/base/check.h"

namespace ocelli {

std::map<uint32_t, Box> boxesOfObjects(const Mesh& mesh, const std::vector<uint32_t>& objectOfTriangle) {
  OC_CHECK(objectOfTriangle.size() == mesh.triangles.size(), "each triangle belongs to an object");
  std::map<uint32_t, Box> boxes;
  Box* box = nullptr;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i == 0 || objectOfTriangle[i] != objectOfTriangle[i - 1]) {
      box = &boxes[objectOfTriangle[i]];
    }
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      const glm::vec3& position = mesh.positions[mesh.triangles[i][corner]];
      box->lower = glm::min(box->lower, position);
      box->upper = glm::max(box->upper, position);
    }
  }
  return boxes;
}

}  // namespace ocelli
