#include "oc_core/scene/shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/scene/vertex_shading.h"

namespace ocelli {
namespace {

constexpr float kAmbient = 0.22f;
constexpr float kBack = 0.3f;

}  // namespace

glm::vec3 directionToLight() {
  return glm::normalize(glm::vec3(0.45f, 0.75f, 0.85f));
}

float lambertShade(const glm::vec3& normal) {
  static const glm::vec3 toLight = directionToLight();
  const float cosine = glm::dot(normal, toLight);
  return std::min(1.0f, kAmbient + (1 - kAmbient) * std::max(0.0f, cosine) + kBack * std::max(0.0f, -cosine));
}

bool smoothTogether(const glm::vec3& a, const glm::vec3& b) {
  static const float cosine = static_cast<float>(std::cos(radiansFromDegrees(kCreaseDegrees)));
  const float ab = glm::dot(a, b);
  const float lengths2 = glm::dot(a, a) * glm::dot(b, b);
  return lengths2 <= 0 || (ab > 0 && ab * ab >= cosine * cosine * lengths2);
}

glm::vec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length2 = glm::dot(normal, normal);
  return length2 > 0 && std::isfinite(length2) ? normal : glm::vec3(0);
}

float shadeOfSum(const glm::vec3& normalSum) {
  const float length = glm::length(normalSum);
  return length > 0 ? lambertShade(normalSum / length) : 1.0f;
}

void bakeLambert(Mesh& mesh, std::span<const uint8_t> unlit) {
  VertexShading shading(mesh);
  const std::vector<glm::vec3> unshaded = mesh.colors;
  std::vector<uint8_t> split;
  for (size_t i = 0; !unlit.empty() && i < shading.sources().size(); ++i) {
    split.push_back(unlit[shading.sources()[i]]);
  }
  shading.shade(mesh, unshaded, split);
}

}  // namespace ocelli
