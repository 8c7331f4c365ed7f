#include "oc_core/evaluation/false_surfaces.h"

#include "oc_core/base/parallel.h"

namespace ocelli {

SurfaceSearch searchOf(const RayScene& scene) {
  return [&scene](const glm::vec3& point, float reach) { return scene.hasSurfaceNear(point, reach); };
}

Image<uint8_t> falseSkins(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                          const SurfaceSearch& hasSurfaceNear) {
  OC_CHECK(frame.width() == truth.width() && frame.height() == truth.height(), "truth and frame have the same size");
  Image<uint8_t> skins(frame.width(), frame.height(), 0);
  parallelFor(static_cast<size_t>(frame.height()), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < frame.width(); ++x) {
        if (frame(x, y).w > 0) {
          const glm::vec3 point(frame(x, y));
          const float reach = nearReach(camera, point);
          // Samples of the truth are points of the surface.
          skins(x, y) = hasSampleNear(truth, x, y, point, reach) || hasSurfaceNear(point, reach) ? 0 : 1;
        }
      }
    }
  });
  return skins;
}

Image<uint8_t> falseSkins(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                          const RayScene& scene) {
  return falseSkins(camera, truth, frame, searchOf(scene));
}

Image<uint8_t> wrongFronts(const PinholeCamera& camera, const Image<glm::vec4>& truth, const Image<glm::vec4>& frame,
                           const Image<SampleState>& states) {
  Image<uint8_t> fronts(truth.width(), truth.height(), 0);
  for (size_t i = 0; i < states.size(); ++i) {
    if ((states[i] == SampleState::kMissing || states[i] == SampleState::kMissingThick) && frame[i].w > 0) {
      const glm::vec3 hidden(truth[i]);
      const float gap = camera.cameraFromWorld(hidden).z - camera.cameraFromWorld(glm::vec3(frame[i])).z;
      fronts[i] = gap > nearReach(camera, hidden) ? 1 : 0;
    }
  }
  return fronts;
}

}  // namespace ocelli
