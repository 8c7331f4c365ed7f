#include "display_sim/slicing/display_bounds.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

bool liesWithin(const Mesh& mesh, const DisplayProfile& profile) {
  constexpr double kRounding = 1e-5;  // of fitting a scene
  return std::ranges::all_of(mesh.positions, [&](const glm::vec3& p) {
    return std::hypot(p.x, p.z) <= 1 + kRounding && std::abs(p.y) <= profile.halfHeightRadii + kRounding;
  });
}

}  // namespace ocelli
