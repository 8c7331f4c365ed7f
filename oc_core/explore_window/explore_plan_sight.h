// Which piece of a plan a pane shows: all of it, or as much larger as is wished, around the walker.
#pragma once

#include <glm/vec2.hpp>

#include "oc_core/explore_window/explore_layout.h"

namespace ocelli {

struct ExplorePlanSight {
  glm::vec2 middle{0};  ///< of the pane, in the plan
  float scale = 1;      ///< screen coordinates for a unit of the plan
  glm::vec2 center{0};  ///< of the pane, on the screen

  glm::vec2 onScreen(const glm::vec2& plan) const { return center + (plan - middle) * scale; }
  glm::vec2 inPlan(const glm::vec2& point) const { return middle + (point - center) / scale; }
};

/// At a zoom of 1 all of the plan from `lower` to `upper` shows. Where it is larger the walker is in the middle, unless
/// the plan would end within the pane.
ExplorePlanSight explorePlanSight(const ExplorePaneRect& rect, const glm::vec2& lower, const glm::vec2& upper,
                                  const glm::vec2& walker, float zoom);

/// 1, 2 or 5 times a power of ten: the longest of these lengths that is at most `longest`, which is positive.
float roundExploreLength(float longest);

}  // namespace ocelli
