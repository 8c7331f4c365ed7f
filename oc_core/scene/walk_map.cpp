#include "oc_core/scene/walk_map.h"

namespace ocelli {

WalkMap moved(const WalkMap& map, const glm::mat4& newFromOld) {
  const float scale = newFromOld[0][0];
  WalkMap result = map;
  for (WalkCell& cell : result.cells) {
    cell.center = glm::vec3(newFromOld * glm::vec4(cell.center, 1));
    cell.halfLength *= scale;
    cell.halfWidth *= scale;
    cell.height *= scale;
    cell.floorRise *= scale;
    for (WalkRing& ring : cell.rings) {
      ring = {ring.along * scale, ring.left * scale, ring.right * scale, ring.ceiling * scale};
    }
  }
  for (WalkPortal& portal : result.portals) {
    portal.opening = moved(portal.opening, newFromOld);
  }
  return result;
}

}  // namespace ocelli
