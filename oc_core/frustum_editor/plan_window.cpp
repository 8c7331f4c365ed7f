#include "oc_core/frustum_editor/plan_window.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr double kPlanMargin = 1.08;  // of the side of what a plan shows
constexpr double kMinUnitsPerPixel = 1e-6;
constexpr double kMaxUnitsPerPixel = 1e6;

}  // namespace

glm::dvec2 paperFromWorld(PlanSide side, const glm::dvec3& point) {
  switch (side) {
    case PlanSide::kTop:
      return {point.x, point.z};
    case PlanSide::kFront:
      return {point.x, -point.y};
    case PlanSide::kRight:
      return {-point.z, -point.y};
  }
  return {0, 0};
}

glm::dvec3 worldFromPaper(PlanSide side, const glm::dvec2& paper, double along) {
  switch (side) {
    case PlanSide::kTop:
      return {paper.x, along, paper.y};
    case PlanSide::kFront:
      return {paper.x, -paper.y, along};
    case PlanSide::kRight:
      return {along, -paper.y, -paper.x};
  }
  return {0, 0, 0};
}

glm::dvec3 viewAxisOf(PlanSide side) {
  glm::dvec3 axis(0);
  axis[axisOf(side)] = 1;
  return axis;
}

const char* nameOf(PlanSide side) {
  switch (side) {
    case PlanSide::kTop:
      return "top";
    case PlanSide::kFront:
      return "front";
    case PlanSide::kRight:
      return "right";
  }
  return "";
}

PlanWindow PlanWindow::around(PlanSide side, const Box& box, const glm::ivec2& size) {
  const glm::dvec2 a = paperFromWorld(side, glm::dvec3(box.lower));
  const glm::dvec2 b = paperFromWorld(side, glm::dvec3(box.upper));
  const glm::dvec2 extent = glm::abs(b - a) * kPlanMargin / glm::dvec2(glm::max(size, glm::ivec2(1)));
  return {side, (a + b) * 0.5, std::clamp(std::max(extent.x, extent.y), kMinUnitsPerPixel, kMaxUnitsPerPixel), size};
}

glm::dvec2 PlanWindow::pixelFromPaper(const glm::dvec2& paper) const {
  return (paper - middle) / unitsPerPixel + glm::dvec2(size) * 0.5;
}

glm::dvec2 PlanWindow::paperFromPixel(const glm::dvec2& pixel) const {
  return (pixel - glm::dvec2(size) * 0.5) * unitsPerPixel + middle;
}

void PlanWindow::zoom(double factor, const glm::dvec2& at) {
  const glm::dvec2 kept = paperFromPixel(at);
  unitsPerPixel = std::clamp(unitsPerPixel / factor, kMinUnitsPerPixel, kMaxUnitsPerPixel);
  middle += kept - paperFromPixel(at);
}

void PlanWindow::pan(const glm::dvec2& pixels) {
  middle -= pixels * unitsPerPixel;
}

}  // namespace ocelli
