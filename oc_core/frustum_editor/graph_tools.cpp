#include "oc_core/frustum_editor/graph_tools.h"

#include <array>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/plan_turns.h"
#include "oc_core/frustum_editor/stroke_frusta.h"

namespace ocelli {
namespace {

constexpr double kClickShare = 1e-3;  // of the scene's diagonal: a shorter stroke is a click
constexpr double kClickSlope = 0.3;   // of the planes of a split that a click makes

bool isClick(const DrawnCamera& camera, const PlanStroke& stroke) {
  return stroke.length() < kClickShare * static_cast<double>(glm::length(camera.room.size()));
}

/// A direction in the plan, to the right of where the rays of a frustum run.
glm::dvec3 acrossOf(const DrawnFrustum& frustum, PlanSide side) {
  const glm::dvec3 across = glm::cross(frustum.direction, viewAxisOf(side));
  if (!(glm::length(across) > 1e-6)) {
    throw InputError("this plan looks along the rays of \"" + frustum.name + "\"", "plan", "draw in another plan");
  }
  return glm::normalize(across);
}

/// Along a stroke through the frustum; across its rays for a click.
DrawnEditPlane planeOfStroke(const DrawnCamera& camera, const DrawnFrustum& frustum, const PlanStroke& stroke) {
  const glm::dvec3 a = onMiddleRays(frustum, stroke.side, stroke.from);
  if (isClick(camera, stroke)) {
    return planeAcross(stroke.side, a, a + acrossOf(frustum, stroke.side), frustum.direction);
  }
  const glm::dvec3 b = onMiddleRays(frustum, stroke.side, stroke.to);
  DrawnEditPlane plane = planeAcross(stroke.side, a, b, frustum.direction);
  plane.point = (a + b) * 0.5;
  return plane;
}

}  // namespace

StrokeEdit bendStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum& frustum = frustumOfStroke(camera, stroke);
  const std::string name = camera.freeName();
  return {DrawnEdits(camera).addBend(frustum.name, name, planeOfStroke(camera, frustum, stroke), frustum.viewpoint,
                                     freePart(camera, frustum)),
          name};
}

StrokeEdit addStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  if (isClick(camera, stroke)) {
    return {};
  }
  const DrawnFrustum& frustum = frustumOfStroke(camera, stroke);
  const std::string name = camera.freeName();
  return {DrawnEdits(camera).addBend(frustum.name, name, planeOfStroke(camera, frustum, stroke), frustum.viewpoint,
                                     partBetween(camera, frustum, stroke.side, stroke.from, stroke.to)),
          name};
}

/// The planes meet where the stroke begins, and lie back to where it ends, to both sides alike.
StrokeEdit splitStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum& frustum = frustumUnder(camera, stroke.side, stroke.from, stroke.selected);
  const glm::dvec3 edge = onMiddleRays(frustum, stroke.side, stroke.from);
  const glm::dvec3 right = acrossOf(frustum, stroke.side);
  const glm::dvec3 ahead = glm::normalize(glm::cross(viewAxisOf(stroke.side), right));
  const glm::dvec3 drawn = worldFromPaper(stroke.side, stroke.to, edge[axisOf(stroke.side)]) - edge;
  double beside = std::abs(glm::dot(drawn, right));
  double back = -std::abs(glm::dot(drawn, ahead));
  if (isClick(camera, stroke) || !(beside > 0)) {
    beside = 1;
    back = -kClickSlope;
  }
  std::array<DrawnEditPlane, 2> planes;
  planes[0] = planeAcross(stroke.side, edge, edge - right * beside + ahead * back, frustum.direction);
  planes[1] = planeAcross(stroke.side, edge, edge + right * beside + ahead * back, frustum.direction);
  planes[0].point = planes[1].point = edge;
  const std::string stem = camera.freeName();
  const std::array<std::string, 2> names{stem + " left", stem + " right"};
  return {DrawnEdits(camera).addSplit(frustum.name, names, planes, frustum.viewpoint), names[0]};
}

/// From one frustum to the other; the plane is where the stroke ends.
StrokeEdit mergeStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum& one = frustumUnder(camera, stroke.side, stroke.from);
  const DrawnFrustum& other = frustumUnder(camera, stroke.side, stroke.to);
  if (one.name == other.name) {
    return {};
  }
  const glm::dvec3 ahead = one.direction + other.direction;
  if (!(glm::length(ahead) > 1e-6)) {
    throw InputError("the rays of \"" + one.name + "\" and \"" + other.name + "\" run against each other", "plan",
                     "merge such as run side by side");
  }
  const glm::dvec3 at = onMiddleRays(other, stroke.side, stroke.to);
  // Where both come from one frustum, its rays go on behind the merge as if nothing had been.
  const DrawnFrustum* parent = one.of == other.of && one.of.size() == 1 ? camera.find(one.of[0]) : nullptr;
  const glm::dvec3 viewpoint = parent != nullptr ? parent->viewpoint : (one.viewpoint + other.viewpoint) * 0.5;
  const std::string name = camera.freeName();
  const std::array<std::string, 2> of{one.name, other.name};
  return {DrawnEdits(camera).addMerge(of, name, {at, glm::normalize(ahead)}, viewpoint), name};
}

/// What lies on the side of the stroke away from where the frustum begins is not seen.
StrokeEdit limitStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  const DrawnFrustum& frustum = frustumOfStroke(camera, stroke, stroke.selected);
  DrawnEditPlane plane = planeOfStroke(camera, frustum, stroke);
  if (Plane::through(plane.point, plane.normal).height(frustum.begins.middle) > 0) {
    plane.normal = -plane.normal;
  }
  std::vector<DrawnEditPlane> limits = DrawnEdits::limitsOf(frustum);
  limits.push_back(plane);
  return {DrawnEdits(camera).limits(frustum.name, limits), frustum.name};
}

}  // namespace ocelli
