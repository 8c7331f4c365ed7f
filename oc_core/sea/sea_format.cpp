#include "oc_core/sea/sea_format.h"

namespace ocelli::sea {

PoseEntry entryOf(const SeaPose& pose) {
  PoseEntry entry;
  const glm::dquat& q = pose.worldFromCamera;
  entry.position = {pose.position.x, pose.position.y, pose.position.z};
  entry.worldFromCamera = {q.w, q.x, q.y, q.z};
  return sealed(entry);
}

SeaPose poseOf(const PoseEntry& entry) {
  const auto& [w, x, y, z] = entry.worldFromCamera;
  return {{entry.position[0], entry.position[1], entry.position[2]}, glm::dquat(w, x, y, z)};
}

}  // namespace ocelli::sea
