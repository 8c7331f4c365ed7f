// Handles of a turn of a curved ray camera (Figure 4.24): its three planes, and the line where they meet. Its viewpoint
// is in frustum_handles.cpp.
#include <array>

#include "oc_core/frustum_editor/handle_list.h"
#include "oc_core/frustum_editor/plan_turns.h"

namespace ocelli {
namespace {

constexpr std::array<const char*, 3> kTurnFields{"from", "middle", "to"};

bool isTurn(const DrawnFrustum& frustum) {
  return frustum.operation == "turn";
}

std::string planesEdit(const DrawnCamera& camera, const std::string& name,
                       const std::array<DrawnEditPlane, 3>& planes) {
  std::vector<std::string> edits;
  for (size_t i = 0; i < planes.size(); ++i) {
    edits.push_back(DrawnEdits(camera).plane(name, kTurnFields[i], planes[i]));
  }
  return DrawnEdits::several(edits);
}

std::vector<FrustumHandle> turnMiddlesOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide) {
  if (!isTurn(frustum)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = frustum.begins.middle;
  return {handle};
}

std::string dragTurnMiddle(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& turn = *camera.find(handle.frustum);
  const glm::dvec3 line = turn.turnLine + to - turn.begins.middle;
  return planesEdit(camera, turn.name,
                    {DrawnEditPlane{line, turn.turn[0].plane.normal},
                     {line, turn.turn[1].plane.normal},
                     {line, turn.turn[2].plane.normal}});
}

std::vector<FrustumHandle> turnLinesOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide side) {
  // A plan along which the line lies shows nothing to turn about.
  if (!isTurn(frustum) || !endsOf(frustum.turn[1], side)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = frustum.turnLine;
  return {handle};
}

/// The planes turn about their far ends, so that they meet elsewhere.
std::string dragTurnLine(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& turn = *camera.find(handle.frustum);
  std::array<DrawnEditPlane, 3> planes;
  for (size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = turn.turn[i].plane;
    const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(turn.turn[i], handle.side);
    if (!ends) {
      planes[i] = {to, plane.normal};
      continue;
    }
    const bool firstIsFar = glm::distance((*ends)[0], turn.turnLine) > glm::distance((*ends)[1], turn.turnLine);
    planes[i] = turnedPlane(handle.side, plane, (*ends)[firstIsFar ? 0 : 1], turn.turnLine, to);
    planes[i].point = to;
  }
  return planesEdit(camera, turn.name, planes);
}

/// The far end of each of the planes.
std::vector<FrustumHandle> turnPlanesOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide side) {
  std::vector<FrustumHandle> handles;
  for (size_t i = 0; i < frustum.turn.size(); ++i) {
    if (const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(frustum.turn[i], side)) {
      const bool firstIsFar = glm::distance((*ends)[0], frustum.turnLine) > glm::distance((*ends)[1], frustum.turnLine);
      FrustumHandle handle;
      handle.index = static_cast<int>(i);
      handle.at = (*ends)[firstIsFar ? 0 : 1];
      handles.push_back(handle);
    }
  }
  return handles;
}

std::string dragTurnPlane(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& turn = *camera.find(handle.frustum);
  const size_t i = static_cast<size_t>(handle.index);
  return DrawnEdits(camera).plane(turn.name, kTurnFields.at(i),
                                  turnedPlane(handle.side, turn.turn.at(i).plane, turn.turnLine, handle.at, to));
}

std::vector<HandleNumber> turnPlaneNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const DrawnFrustum& turn = *camera.find(handle.frustum);
  const size_t i = static_cast<size_t>(handle.index);
  const glm::dvec3 normal = turn.turn.at(i).plane.normal;
  const double heading = headingDegrees(normal);
  return {{"heading", "degrees", heading, [&camera, handle, i, normal](double value) {
             return DrawnEdits(camera).plane(
                 handle.frustum, kTurnFields.at(i),
                 {camera.find(handle.frustum)->turnLine, directionOf(value, pitchDegrees(normal))});
           }}};
}

}  // namespace

HandleKind turnMiddleHandle() {
  return {"turn", "moves the three planes of a turn", Marker::kSquare, turnMiddlesOf, dragTurnMiddle};
}

HandleKind turnLineHandle() {
  return {"turn line", "moves the line where the planes of a turn meet", Marker::kTriangleDown, turnLinesOf,
          dragTurnLine};
}

HandleKind turnPlaneHandle() {
  return {"turn plane",    "turns a plane of a turn about the line", Marker::kTriangle, turnPlanesOf, dragTurnPlane,
          turnPlaneNumbers};
}

}  // namespace ocelli
