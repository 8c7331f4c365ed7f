#include "oc_core/soft_shadows/area_visibility.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

bool isLit(const ShadowReceiver& receiver, const LightFrame& frame, const ReceiverLift& lift, LitReceiver& lit) {
  const glm::vec3 position = frame.fromWorld(receiver.position);
  const glm::vec3 normal = frame.directionFromWorld(receiver.normal);
  if (!(position.z > 0) || !std::isfinite(glm::dot(position, position)) || !(glm::dot(normal, normal) > 0)) {
    return false;
  }
  // The corner of the light that stands highest over the plane of the surface.
  const glm::vec3 highest(std::copysign(frame.half().x, normal.x), std::copysign(frame.half().y, normal.y), 0);
  const float horizon = glm::dot(normal, position);
  if (!(glm::dot(normal, highest) > horizon)) {
    return false;
  }
  const bool seesHorizon = !(glm::dot(normal, -highest) > horizon);
  const float sampledAt = receiver.isSampled ? position.z : 0;
  const glm::vec3 lifted = position + normal * std::max(lift.least, lift.perDistance * sampledAt) -
                           glm::normalize(position) * (lift.towardsLight * sampledAt);
  lit = {lifted, normal, horizon, seesHorizon};
  return lit.position.z > LightFrame::kMinHalfSide;
}

}  // namespace ocelli
