#include "oc_core/soft_shadows/visibility_reference.h"

#include "oc_core/depth_rays/straight_ray.h"

namespace ocelli {

float visibilitySlowly(const Mesh& occluders, const AreaLight& light, const ShadowReceiver& receiver, int gridSide,
                       const ReceiverLift& lift) {
  const LightFrame frame(light);
  const LightGrid grid(frame, gridSide);
  LitReceiver lit;
  if (!isLit(receiver, frame, lift, lit)) {
    return 0;
  }
  const glm::vec3 from = frame.toWorld(lit.position);
  int seen = 0;
  for (int column = 0; column < gridSide; ++column) {
    for (int row = 0; row < gridSide; ++row) {
      if (!grid.isOnLight(column, row)) {
        continue;
      }
      if (!lit.isAbove(grid.point(column, row))) {
        continue;
      }
      const StraightRay ray{from, frame.toWorld(grid.point(column, row)) - from, 1};
      bool isHidden = false;
      for (uint32_t i = 0; i < occluders.triangles.size() && !isHidden; ++i) {
        const glm::uvec3& t = occluders.triangles[i];
        isHidden = meetTriangle(ray, occluders.positions[t.x], occluders.positions[t.y], occluders.positions[t.z], i)
                       .has_value();
      }
      seen += isHidden ? 0 : 1;
    }
  }
  return static_cast<float>(seen) / static_cast<float>(grid.count());
}

}  // namespace ocelli
