#include "oc_core/multiperspective/plan_ground.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr float kFarAway = 300;  // sizes of the scene, from which the ground is seen: perspective is slight there

glm::vec3 pointUnderPaper(PlanSide side, const glm::vec2& p, float at) {
  switch (side) {
    case PlanSide::kTop:
      return {p.x, at, p.y};
    case PlanSide::kFront:
      return {p.x, -p.y, at};
    case PlanSide::kRight:
      return {at, -p.y, -p.x};
  }
  return glm::vec3(0);
}

}  // namespace

/// From so far away that lines of sight are nearly parallel, without what lies before the cut.
Image<Rgb8> planGround(const Mesh& mesh, PlanSide side, const glm::vec2& lower, const glm::vec2& upper, float at,
                       int pixels) {
  const glm::vec2 size = upper - lower;
  const float scale = static_cast<float>(pixels) / std::max(size.x, size.y);
  const int width = std::max(1, static_cast<int>(size.x * scale));
  const int height = std::max(1, static_cast<int>(size.y * scale));
  const int axis = axisOf(side);
  const glm::vec3 sceneSize = boundsOf(mesh).size();
  const float distance = kFarAway * std::max(glm::length(sceneSize), std::max(size.x, size.y));
  const glm::vec2 middle = (lower + upper) * 0.5f;
  View view;
  view.target = pointUnderPaper(side, middle, at);
  view.eye = view.target;
  view.eye[axis] += distance;
  view.up = side == PlanSide::kTop ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(static_cast<double>(size.y / 2 / distance)));
  view.zNear = distance;
  view.zFar = distance + 2 * glm::length(sceneSize);
  const PinholeCamera camera(view, width, height);
  return srgbFromLinear(colorImage(rasterize(camera, mesh), mesh, glm::vec3(1)));
}

}  // namespace ocelli
