// Simplification with vertices that stay. meshoptimizer 0.18 locks all borders or none; but it never moves a vertex
// where three or more stand at one place. So each that must stay gets two more, which no triangle uses: its anchors.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace ocelli {

class AnchoredSimplifier {
 public:
  explicit AnchoredSimplifier(std::span<const glm::vec3> positions);

  /// About `target` indices or more. `stays`: of each vertex whether it must; with one, all at its place do.
  /// `locksRims`: whether the vertices of all open edges stay as well.
  std::vector<uint32_t> fewer(std::span<const uint32_t> indices, std::span<const uint8_t> stays, bool locksRims,
                              size_t target);

 private:
  std::vector<glm::vec3> positions_;
  size_t vertices_;  ///< the others are anchors
};

}  // namespace ocelli
