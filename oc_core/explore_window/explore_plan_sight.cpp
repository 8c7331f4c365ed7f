#include "oc_core/explore_window/explore_plan_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr float kPlanMargin = 0.04f;  // of the pane

/// So that `half` around it stays between both, or in the middle of both where that is impossible.
float clampedAround(float at, float half, float lower, float upper) {
  return 2 * half >= upper - lower ? (lower + upper) / 2 : std::clamp(at, lower + half, upper - half);
}

}  // namespace

ExplorePlanSight explorePlanSight(const ExplorePaneRect& rect, const glm::vec2& lower, const glm::vec2& upper,
                                  const glm::vec2& walker, float zoom) {
  const glm::vec2 size = glm::max(upper - lower, glm::vec2(1e-6f));
  const glm::vec2 room = glm::vec2(rect.width, rect.height) * (1 - 2 * kPlanMargin);
  ExplorePlanSight sight;
  sight.center = {rect.x + rect.width / 2, rect.y + rect.height / 2};
  sight.scale = std::min(room.x / size.x, room.y / size.y) * zoom;
  const glm::vec2 half = room / sight.scale * 0.5f;
  sight.middle = {clampedAround(walker.x, half.x, lower.x, upper.x), clampedAround(walker.y, half.y, lower.y, upper.y)};
  return sight;
}

float roundExploreLength(float longest) {
  const float power = std::pow(10.0f, std::floor(std::log10(longest)));
  for (const float factor : {5.0f, 2.0f}) {
    if (factor * power <= longest) {
      return factor * power;
    }
  }
  return power;
}

}  // namespace ocelli
