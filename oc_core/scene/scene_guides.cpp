#include "oc_core/scene/scene_guides.h"

namespace ocelli {

SceneGuides moved(const SceneGuides& guides, const glm::mat4& newFromOld) {
  const auto point = [&](const glm::vec3& p) { return glm::vec3(newFromOld * glm::vec4(p, 1)); };
  SceneGuides result;
  for (const Portal& portal : guides.portals) {
    result.portals.push_back(moved(portal, newFromOld));
  }
  for (const glm::vec3& p : guides.path) {
    result.path.push_back(point(p));
  }
  if (guides.target) {
    result.target = {guides.target->object, {point(guides.target->box.lower), point(guides.target->box.upper)}};
  }
  if (guides.maze) {
    result.maze = moved(*guides.maze, newFromOld);
  }
  if (guides.walk) {
    result.walk = moved(*guides.walk, newFromOld);
  }
  return result;
}

}  // namespace ocelli
