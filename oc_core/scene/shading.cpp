#include "oc_core/scene/shading.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/scene/vertex_shading.h"

namespace ocelli {
namespace {

constexpr float kAmbient = 0.22f;
constexpr float kBack = 0.3f;

glm::vec3 directionToLight() {
  return glm::normalize(glm::vec3(0.45f, 0.75f, 0.85f));
}

}  // namespace

float lambertShade(const glm::vec3& normal) {
  static const glm::vec3 toLight = directionToLight();
  const float cosine = glm::dot(normal, toLight);
  return std::min(1.0f, kAmbient + (1 - kAmbient) * std::max(0.0f, cosine) + kBack * std::max(0.0f, -cosine));
}

void bakeLambert(Mesh& mesh) {
  VertexShading shading(mesh);
  const std::vector<glm::vec3> unshaded = mesh.colors;
  shading.shade(mesh, unshaded);
}

}  // namespace ocelli
