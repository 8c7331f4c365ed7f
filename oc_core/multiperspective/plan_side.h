// The sides that a plan shows a scene from, and what lies where on its paper: lengths as in the world, x to the right,
// y down.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ocelli {

enum class PlanSide {
  kTop,    ///< down along -y; -z, the north of a maze, is at the top
  kFront,  ///< along -z
  kRight,  ///< along -x
};

inline glm::vec2 onPaper(PlanSide side, const glm::vec3& p) {
  switch (side) {
    case PlanSide::kTop:
      return {p.x, p.z};
    case PlanSide::kFront:
      return {p.x, -p.y};
    case PlanSide::kRight:
      return {-p.z, -p.y};
  }
  return {0, 0};
}

/// The coordinate axis that it looks along: 0 for x, 1 for y, 2 for z. Larger coordinates are nearer.
inline int axisOf(PlanSide side) {
  return side == PlanSide::kTop ? 1 : side == PlanSide::kFront ? 2 : 0;
}

}  // namespace ocelli
