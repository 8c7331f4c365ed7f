#include "oc_core/scene/scene_light.h"

#include <algorithm>

#include "oc_core/image/color.h"

namespace ocelli {

bool isBlack(const Mesh& mesh) {
  return !mesh.colors.empty() && std::ranges::all_of(mesh.colors, [](const glm::vec3& color) {
    return srgbByteFromLinear(std::max({color.r, color.g, color.b})) == 0;
  });
}

}  // namespace ocelli
