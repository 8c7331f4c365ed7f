// The edges of occluders at which the number of surfaces between a point and a light can change: those of one triangle,
// and those of two that face a point differently.
//
// Only triangles in front of the light count; what reaches through its plane is cut there. Edges of more than two
// triangles are taken in pairs. Nothing asks how triangles are oriented.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "oc_core/soft_shadows/light_frame.h"

namespace ocelli {

struct OccluderEdge {
  static constexpr uint32_t kNoPlane = 0xffffffffu;

  glm::vec3 a{0};  ///< in the frame of the light
  glm::vec3 b{0};
  uint32_t plane = 0;         ///< of its triangle
  uint32_t other = kNoPlane;  ///< of its second triangle, if there is one
  int otherSign = 0;          ///< whether that runs along it the same way (1) or the other way (-1); 0 without one

  bool isRim() const { return otherSign == 0; }
};

struct OccluderEdges {
  /// The triangles in front of the light, in its frame.
  Mesh mesh;
  /// Of each triangle: on which side of it a point lies is the sign of dot(plane, (point, 1)). Unit normals.
  std::vector<glm::vec4> planes;
  std::vector<OccluderEdge> rims;
  std::vector<OccluderEdge> folds;  ///< between two triangles that do not lie in one plane
};

OccluderEdges occluderEdges(const Mesh& occluders, const LightFrame& frame);

inline float sideOf(const glm::vec4& plane, const glm::vec3& point) {
  return plane.x * point.x + plane.y * point.y + plane.z * point.z + plane.w;
}

/// How many surfaces more lie to the left of the edge than to its right, as seen from `point` against the light's
/// direction with x to the right and y up: -2 to 2.
int weightOf(const OccluderEdge& edge, const std::vector<glm::vec4>& planes, const glm::vec3& point);

}  // namespace ocelli
