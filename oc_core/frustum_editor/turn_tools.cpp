// Drawing turns of curved ray cameras.
#include <array>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/graph_tools.h"
#include "oc_core/frustum_editor/plan_turns.h"
#include "oc_core/frustum_editor/stroke_frusta.h"

namespace ocelli {
namespace {

constexpr double kTurnDegrees = 12;  // between the middle plane and those where the transition begins and ends

}  // namespace

/// From the line where the planes meet, beside the rays, across them: the middle plane. The others lie before and
/// behind.
StrokeEdit turnStroke(const DrawnCamera& camera, const PlanStroke& stroke) {
  if (!(stroke.length() > 0)) {
    return {};
  }
  // Rays can turn but once more behind the last turn.
  const DrawnFrustum& last = camera.frusta.back();
  const glm::dvec3 line = onMiddleRays(last, stroke.side, stroke.from);
  const glm::dvec3 end = worldFromPaper(stroke.side, stroke.to, line[axisOf(stroke.side)]);
  const DrawnEditPlane middle = planeAcross(stroke.side, line, end, last.direction);
  // Before the middle plane, as seen from its far end, is where the rays come from.
  const glm::dvec3 axis = viewAxisOf(stroke.side);
  const double step = radiansFromDegrees(kTurnDegrees);
  const double sign = glm::dot(glm::cross(axis, end - line), middle.normal) > 0 ? 1 : -1;
  const std::array<DrawnEditPlane, 3> planes{DrawnEditPlane{line, turnedAbout(middle.normal, axis, -sign * step)},
                                             DrawnEditPlane{line, middle.normal},
                                             DrawnEditPlane{line, turnedAbout(middle.normal, axis, sign * step)}};
  const std::string name = camera.freeName();
  return {DrawnEdits(camera).addTurn(name, planes, last.viewpoint), name};
}

}  // namespace ocelli
