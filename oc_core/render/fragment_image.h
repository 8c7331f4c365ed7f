// What a renderer leaves at each pixel: which triangle is seen, where on it, and how far away.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "oc_core/image/image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The closest surface sample on the ray of a pixel.
struct Fragment {
  static constexpr uint32_t kNoTriangle = 0xffffffffu;

  float t = 0;  ///< the parameter of the ray (camera.h); 0 where nothing is seen
  uint32_t triangle = kNoTriangle;
  float b1 = 0;  ///< barycentric weights of the second and third vertex
  float b2 = 0;

  bool covered() const { return triangle != kNoTriangle; }
  bool operator==(const Fragment&) const = default;
};

using FragmentImage = Image<Fragment>;

/// The world point of a covered fragment.
inline glm::vec3 positionOf(const Fragment& f, const Mesh& mesh) {
  const glm::uvec3& t = mesh.triangles[f.triangle];
  return mesh.positions[t.x] * (1 - f.b1 - f.b2) + mesh.positions[t.y] * f.b1 + mesh.positions[t.z] * f.b2;
}

/// The linear colour of a covered fragment.
inline glm::vec3 colorOf(const Fragment& f, const Mesh& mesh) {
  if (mesh.colors.empty()) {
    return glm::vec3(1);
  }
  const glm::uvec3& t = mesh.triangles[f.triangle];
  return mesh.colors[t.x] * (1 - f.b1 - f.b2) + mesh.colors[t.y] * f.b1 + mesh.colors[t.z] * f.b2;
}

/// Linear colours, `background` where nothing is seen.
Image<glm::vec3> colorImage(const FragmentImage& fragments, const Mesh& mesh, const glm::vec3& background);

}  // namespace ocelli
