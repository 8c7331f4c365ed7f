#include "oc_core/constructor/object_boxes.h"

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"

namespace ocelli {

std::vector<Box> objectBoxes(const GuidedScene& scene) {
  std::vector<Box> boxes;
  for (size_t i = 0; i < scene.objectOfTriangle.size(); ++i) {
    const size_t object = scene.objectOfTriangle[i];
    if (object >= boxes.size()) {
      boxes.resize(object + 1);
    }
    for (int k = 0; k < 3; ++k) {
      boxes[object].add(scene.mesh.positions[scene.mesh.triangles[i][k]]);
    }
  }
  return boxes;
}

Box readBox(JsonFields& fields, const std::string& name) {
  JsonFields ofBox = fields.inner(name);
  const Box box{glm::vec3(readVector(ofBox, "lower")), glm::vec3(readVector(ofBox, "upper"))};
  ofBox.rejectUnknown();
  for (int i = 0; i < 3; ++i) {
    if (!(box.lower[i] < box.upper[i])) {
      throw InputError("\"lower\" of a box must be less than \"upper\" along each axis", ofBox.where(), "swap them");
    }
  }
  return box;
}

}  // namespace ocelli
