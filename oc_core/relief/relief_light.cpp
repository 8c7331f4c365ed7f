#include "oc_core/relief/relief_light.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/image/color.h"

namespace ocelli {

glm::vec3 directionToSun() {
  static const glm::vec3 direction = glm::normalize(glm::vec3(0.45f, 0.75f, 0.85f));
  return direction;
}

float sunlitShade(const glm::vec3& normal, bool lit) {
  constexpr float kFromEverywhere = 0.25f;
  const float cosine = lit ? std::max(glm::dot(normal, directionToSun()), 0.0f) : 0.0f;
  return kFromEverywhere + (1 - kFromEverywhere) * cosine;
}

glm::vec3 reliefBackground() {
  return linearFromSrgb(glm::vec3(0.80f, 0.88f, 0.95f));
}

}  // namespace ocelli
