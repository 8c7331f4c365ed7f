// A plan that one draws in: which side of the scene it shows (plan_side.h), and what of it, at which scale. Lengths on
// its paper are those of the world; pixels are those of its pane, from the top left.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "oc_core/multiperspective/plan_side.h"
#include "oc_core/scene/box.h"

namespace ocelli {

glm::dvec2 paperFromWorld(PlanSide side, const glm::dvec3& point);
/// `along` is the coordinate that the paper does not show: the height of a plan from above.
glm::dvec3 worldFromPaper(PlanSide side, const glm::dvec2& paper, double along);
/// Towards the reader: the direction that the plan does not show.
glm::dvec3 viewAxisOf(PlanSide side);
/// "top", "front", "right".
const char* nameOf(PlanSide side);

struct PlanWindow {
  PlanSide side = PlanSide::kTop;
  glm::dvec2 middle{0};  ///< on the paper
  double unitsPerPixel = 0.01;
  glm::ivec2 size{1, 1};  ///< of the pane, pixels

  /// All of a box, with a margin. The box is not empty.
  static PlanWindow around(PlanSide side, const Box& box, const glm::ivec2& size);

  glm::dvec2 pixelFromPaper(const glm::dvec2& paper) const;
  glm::dvec2 paperFromPixel(const glm::dvec2& pixel) const;
  glm::dvec2 pixelFromWorld(const glm::dvec3& point) const { return pixelFromPaper(paperFromWorld(side, point)); }

  /// What is at a pixel stays there; the scale stays within sensible limits. More than 1 shows less of the scene.
  void zoom(double factor, const glm::dvec2& at);
  /// The paper moves by `pixels`.
  void pan(const glm::dvec2& pixels);
};

}  // namespace ocelli
