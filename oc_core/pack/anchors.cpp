#include "oc_core/pack/anchors.h"

#include <meshoptimizer.h>

#include <algorithm>

#include "oc_core/base/check.h"

namespace ocelli {

AnchoredSimplifier::AnchoredSimplifier(std::span<const glm::vec3> positions)
    : positions_(positions.begin(), positions.end()), vertices_(positions.size()) {}

std::vector<uint32_t> AnchoredSimplifier::fewer(std::span<const uint32_t> indices, std::span<const uint8_t> stays,
                                                bool locksRims, size_t target) {
  positions_.resize(vertices_);
  for (size_t i = 0; i < vertices_; ++i) {
    if (stays[i] != 0) {
      const glm::vec3 at = positions_[i];
      positions_.insert(positions_.end(), 2, at);
    }
  }
  std::vector<uint32_t> fewer(indices.size());
  constexpr float kAnyError = 1;  // of the extent: as much as the target asks for
  fewer.resize(meshopt_simplify(fewer.data(), indices.data(), indices.size(), &positions_[0].x, positions_.size(),
                                sizeof(glm::vec3), target, kAnyError,
                                locksRims ? unsigned{meshopt_SimplifyLockBorder} : 0U, nullptr));
  OC_CHECK(std::ranges::all_of(fewer, [&](uint32_t vertex) { return vertex < vertices_; }),
           "no triangle is moved to an anchor");
  return fewer;
}

}  // namespace ocelli
