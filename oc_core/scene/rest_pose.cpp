#include "oc_core/scene/rest_pose.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ocelli {

void poseAtRest(SceneRecord& record) {
  if (!record.rig) {
    return;
  }
  const Rig rig = std::move(*record.rig);
  record.rig.reset();
  const std::vector<glm::mat4> worldFromNode = worldFromNodes(rig, RigAnimation{}, 0);
  for (Instance& instance : record.instances) {
    const RigPart& part = rig.parts[instance.mesh];
    std::vector<float> weights;
    std::ranges::transform(part.morphs, std::back_inserter(weights), &RigMorph::weight);
    const bool hasBones = !part.bones.empty();
    if (!hasBones && std::ranges::all_of(weights, [](float weight) { return weight == 0; })) {
      continue;
    }
    TexturedMesh posed = record.parts[instance.mesh];
    // Bones lead to the world; without them a copy stays at its node.
    const glm::mat4 worldFromMesh = hasBones ? instance.worldFromMesh : glm::mat4(1);
    skin(part, record.parts[instance.mesh].mesh.positions, worldFromNode, worldFromMesh, weights, posed.mesh.positions);
    instance.mesh = record.parts.size();
    if (hasBones) {
      instance.worldFromMesh = glm::mat4(1);
    }
    record.parts.push_back(std::move(posed));
  }
  std::vector<char> isUsed(record.parts.size(), 0);
  for (const Instance& instance : record.instances) {
    isUsed[instance.mesh] = 1;
  }
  for (size_t i = 0; i < record.parts.size(); ++i) {
    if (isUsed[i] == 0) {
      record.parts[i] = {};
    }
  }
}

}  // namespace ocelli
