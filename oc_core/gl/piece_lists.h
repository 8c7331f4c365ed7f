// Lists of pieces of triangles on the GPU (shaders/piece.glsl), and how many pieces groups of invocations put into
// them.
#pragma once

#include <glm/vec4.hpp>

#include "oc_core/gl/gl_object.h"

namespace ocelli {

inline constexpr size_t kPieceBytes = 28;

/// Where shaders that make lists find what they read, their counts, and what they write.
inline constexpr uint32_t kSourceBinding = 2;
inline constexpr uint32_t kGroupsBinding = 3;
inline constexpr uint32_t kChildrenBinding = 5;

inline uint32_t groupsOf(uint32_t items, uint32_t group) {
  return (items + group - 1) / group;
}

/// Turns the counts of so many groups into how many come before each (shaders/prefix_sum.comp), waits, and returns the
/// totals: leaves, children, triangles to be clipped. Hold a GlScope.
glm::uvec4 sumGroups(GlContext& context, const GlObject& prefixSum, const GlObject& groups, uint32_t count);

}  // namespace ocelli
