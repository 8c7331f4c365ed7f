// Handles of the planes where frusta begin: the whole plane, its ends, and the edge where the planes of a split meet.
#include <cmath>

#include "oc_core/frustum_editor/handle_list.h"
#include "oc_core/frustum_editor/plan_turns.h"

namespace ocelli {
namespace {

constexpr double kAtEdgeShare = 0.02;  // of a plane's width: an end so near to the edge of its split is that edge

bool beginsAtPlane(const DrawnFrustum& frustum) {
  return frustum.operation == "bend" || frustum.operation == "split" || frustum.operation == "merge";
}

/// The other half of a split; null where there is none.
const DrawnFrustum* otherHalf(const DrawnCamera& camera, const DrawnFrustum& frustum) {
  for (const DrawnFrustum& each : camera.frusta) {
    if (frustum.operation == "split" && each.operation == "split" && each.of == frustum.of &&
        each.name != frustum.name) {
      return &each;
    }
  }
  return nullptr;
}

/// A point of the line where two planes meet that is near to `to`.
glm::dvec3 meetingPoint(const Plane& a, const Plane& b, const glm::dvec3& to) {
  const glm::dvec3 along = glm::cross(a.normal, b.normal);
  const glm::dvec3 point =
      (glm::cross(b.normal, along) * a.distance + glm::cross(along, a.normal) * b.distance) / glm::dot(along, along);
  return point + along * (glm::dot(to - point, along) / glm::dot(along, along));
}

glm::dvec3 edgeOfSplit(const DrawnFrustum& one, const DrawnFrustum& other) {
  return meetingPoint(one.begins.plane, other.begins.plane, (one.begins.middle + other.begins.middle) * 0.5);
}

double paperDistance(PlanSide side, const glm::dvec3& a, const glm::dvec3& b) {
  return glm::distance(paperFromWorld(side, a), paperFromWorld(side, b));
}

std::vector<FrustumHandle> planesOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide) {
  if (!beginsAtPlane(frustum)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = frustum.begins.middle;
  return {handle};
}

std::string dragPlane(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& frustum = *camera.find(handle.frustum);
  return DrawnEdits(camera).plane(handle.frustum, "plane", {to, frustum.begins.plane.normal});
}

std::vector<HandleNumber> planeNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const DrawnPlane& begins = camera.find(handle.frustum)->begins;
  const double heading = headingDegrees(begins.plane.normal);
  const double pitch = pitchDegrees(begins.plane.normal);
  const auto turn = [&camera, handle](double newHeading, double newPitch) {
    return DrawnEdits(camera).plane(handle.frustum, "plane",
                                    {camera.find(handle.frustum)->begins.middle, directionOf(newHeading, newPitch)});
  };
  return {{"heading", "degrees", heading, [=](double value) { return turn(value, pitch); }},
          {"pitch", "degrees", pitch, [=](double value) { return turn(heading, value); }}};
}

std::vector<FrustumHandle> planeEndsOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side) {
  std::vector<FrustumHandle> handles;
  const std::optional<std::array<glm::dvec3, 2>> ends =
      beginsAtPlane(frustum) ? endsOf(frustum.begins, side) : std::nullopt;
  if (!ends) {
    return handles;
  }
  const DrawnFrustum* other = otherHalf(camera, frustum);
  const double width = paperDistance(side, (*ends)[0], (*ends)[1]);
  for (size_t end = 0; end < 2; ++end) {
    if (other != nullptr && paperDistance(side, edgeOfSplit(frustum, *other), (*ends)[end]) < kAtEdgeShare * width) {
      continue;  // the edge of the split has a handle of its own
    }
    FrustumHandle handle;
    handle.index = static_cast<int>(end);
    handle.at = (*ends)[end];
    handles.push_back(handle);
  }
  return handles;
}

std::string dragPlaneEnd(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnPlane& begins = camera.find(handle.frustum)->begins;
  const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(begins, handle.side);
  if (!ends) {
    return dragPlane(camera, handle, to);
  }
  const size_t end = static_cast<size_t>(handle.index);
  return DrawnEdits(camera).plane(handle.frustum, "plane",
                                  turnedPlane(handle.side, begins.plane, (*ends)[1 - end], (*ends)[end], to));
}

std::vector<FrustumHandle> splitEdgesOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side) {
  const DrawnFrustum* other = otherHalf(camera, frustum);
  // One of the two halves has it.
  if (other == nullptr || other < &frustum || !endsOf(frustum.begins, side) || !endsOf(other->begins, side)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = edgeOfSplit(frustum, *other);
  return {handle};
}

/// Each plane turns about its outer end.
std::string dragSplitEdge(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& frustum = *camera.find(handle.frustum);
  const DrawnFrustum* other = otherHalf(camera, frustum);
  if (other == nullptr) {
    return dragPlane(camera, handle, to);
  }
  const glm::dvec3 edge = edgeOfSplit(frustum, *other);
  std::vector<std::string> edits;
  for (const DrawnFrustum* half : {&frustum, other}) {
    const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(half->begins, handle.side);
    if (!ends) {
      continue;
    }
    const bool firstIsOuter =
        paperDistance(handle.side, (*ends)[0], edge) > paperDistance(handle.side, (*ends)[1], edge);
    const glm::dvec3 outer = (*ends)[firstIsOuter ? 0 : 1];
    edits.push_back(
        DrawnEdits(camera).plane(half->name, "plane", turnedPlane(handle.side, half->begins.plane, outer, edge, to)));
  }
  return DrawnEdits::several(edits);
}

std::string changeLimit(const DrawnCamera& camera, const FrustumHandle& handle, size_t limit,
                        const DrawnEditPlane& plane) {
  std::vector<DrawnEditPlane> planes = DrawnEdits::limitsOf(*camera.find(handle.frustum));
  planes.at(limit) = plane;
  return DrawnEdits(camera).limits(handle.frustum, planes);
}

std::vector<FrustumHandle> limitsOfFrustum(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide) {
  std::vector<FrustumHandle> handles;
  for (size_t i = 0; i < frustum.limits.size(); ++i) {
    FrustumHandle handle;
    handle.index = static_cast<int>(i);
    handle.at = frustum.limits[i].middle;
    handles.push_back(handle);
  }
  return handles;
}

std::string dragLimit(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const size_t i = static_cast<size_t>(handle.index);
  return changeLimit(camera, handle, i, {to, camera.find(handle.frustum)->limits.at(i).plane.normal});
}

std::vector<HandleNumber> limitNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const size_t i = static_cast<size_t>(handle.index);
  const DrawnPlane& limit = camera.find(handle.frustum)->limits.at(i);
  const double heading = headingDegrees(limit.plane.normal);
  const double pitch = pitchDegrees(limit.plane.normal);
  const auto turn = [&camera, handle, i](double newHeading, double newPitch) {
    return changeLimit(camera, handle, i, {handle.at, directionOf(newHeading, newPitch)});
  };
  return {{"heading", "degrees", heading, [=](double value) { return turn(value, pitch); }},
          {"pitch", "degrees", pitch, [=](double value) { return turn(heading, value); }}};
}

std::vector<FrustumHandle> limitEndsOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide side) {
  std::vector<FrustumHandle> handles;
  for (size_t i = 0; i < frustum.limits.size(); ++i) {
    if (const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(frustum.limits[i], side)) {
      for (size_t end = 0; end < 2; ++end) {
        FrustumHandle handle;
        handle.index = static_cast<int>(2 * i + end);
        handle.at = (*ends)[end];
        handles.push_back(handle);
      }
    }
  }
  return handles;
}

std::string dragLimitEnd(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const size_t i = static_cast<size_t>(handle.index) / 2;
  const size_t end = static_cast<size_t>(handle.index) % 2;
  const DrawnPlane& limit = camera.find(handle.frustum)->limits.at(i);
  const std::optional<std::array<glm::dvec3, 2>> ends = endsOf(limit, handle.side);
  if (!ends) {
    return changeLimit(camera, handle, i, {to, limit.plane.normal});
  }
  return changeLimit(camera, handle, i, turnedPlane(handle.side, limit.plane, (*ends)[1 - end], (*ends)[end], to));
}

}  // namespace

HandleKind planeHandle() {
  return {"plane", "moves the plane where the frustum begins", Marker::kSquare, planesOf, dragPlane, planeNumbers};
}

HandleKind planeEndHandle() {
  return {"plane end", "turns the plane about its other end", Marker::kTriangle, planeEndsOf, dragPlaneEnd};
}

HandleKind splitEdgeHandle() {
  return {"split edge", "moves the line where the planes of a split meet", Marker::kTriangleDown, splitEdgesOf,
          dragSplitEdge};
}

HandleKind limitHandle() {
  return {"limit", "moves a limit of the frustum", Marker::kSquare, limitsOfFrustum, dragLimit, limitNumbers};
}

HandleKind limitEndHandle() {
  return {"limit end", "turns a limit about its other end", Marker::kTriangle, limitEndsOf, dragLimitEnd};
}

}  // namespace ocelli
