#include "display_sim/viewer/volume_shown.h"

namespace ocelli {

std::vector<ClipPlane> clipsOf(const VolumeScene& scene, const std::array<glm::dvec2, 3>& kept) {
  std::vector<ClipPlane> clips = scene.clips;
  const std::vector<ClipPlane> more = clipPlanesOf(kept, scene.bounds());
  clips.insert(clips.end(), more.begin(), more.end());
  return clips;
}

std::vector<ClipPlane> clipPlanesOf(const std::array<glm::dvec2, 3>& kept, const Box& bounds) {
  std::vector<ClipPlane> planes;
  const glm::dvec3 lower(bounds.lower);
  const glm::dvec3 size = glm::dvec3(bounds.upper) - lower;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec2& share = kept[static_cast<size_t>(axis)];
    glm::dvec3 normal(0);
    normal[axis] = 1;
    if (share.x > 0) {
      planes.push_back({normal, lower[axis] + share.x * size[axis]});
    }
    if (share.y < 1) {
      planes.push_back({-normal, -(lower[axis] + share.y * size[axis])});
    }
  }
  return planes;
}

}  // namespace ocelli
