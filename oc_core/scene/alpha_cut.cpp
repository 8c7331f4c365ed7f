#include "oc_core/scene/alpha_cut.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <unordered_map>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {

// Of the eight cases of marching triangles those with one corner kept and with two differ by which corner that is.
std::vector<EdgeVertex> cutAway(Mesh& mesh, const std::vector<float>& values, float least) {
  OC_CHECK(values.size() == mesh.positions.size(), "there is a value a vertex");
  std::vector<EdgeVertex> added;
  std::unordered_map<uint64_t, uint32_t> known;
  const auto isKept = [&](uint32_t vertex) { return values[vertex] >= least; };
  /// On the edge of a vertex that is kept and one that is not.
  const auto between = [&](uint32_t a, uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [slot, isNew] = known.try_emplace(uint64_t{low} << 32U | high, 0);
    if (isNew) {
      const float share = std::clamp((least - values[low]) / (values[high] - values[low]), 0.0f, 1.0f);
      slot->second = static_cast<uint32_t>(mesh.positions.size());
      added.push_back({low, high, share});
      mesh.positions.push_back(glm::mix(mesh.positions[low], mesh.positions[high], share));
      if (!mesh.colors.empty()) {
        mesh.colors.push_back(glm::mix(mesh.colors[low], mesh.colors[high], share));
      }
    }
    return slot->second;
  };
  std::vector<glm::uvec3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const int kept = int{isKept(t.x)} + int{isKept(t.y)} + int{isKept(t.z)};
    if (kept == 3) {
      triangles.push_back(t);
      continue;
    }
    if (kept == 0) {
      continue;
    }
    // Turned so that its first corner differs from the others.
    std::array<uint32_t, 3> corners{t.x, t.y, t.z};
    const bool wanted = kept == 1;
    while (isKept(corners[0]) != wanted) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    const uint32_t ab = between(corners[0], corners[1]);
    const uint32_t ac = between(corners[0], corners[2]);
    if (kept == 1) {
      triangles.emplace_back(corners[0], ab, ac);
    } else {
      triangles.emplace_back(ab, corners[1], corners[2]);
      triangles.emplace_back(ab, corners[2], ac);
    }
  }
  mesh.triangles = std::move(triangles);
  return added;
}

}  // namespace ocelli
