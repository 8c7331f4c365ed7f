// Handles of a frustum behind a bend: its viewpoint, and where its rays go.
#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/drawn_edits.h"
#include "oc_core/frustum_editor/handle_list.h"
#include "oc_core/frustum_editor/plan_turns.h"

namespace ocelli {
namespace {

constexpr double kMaxAimShare = 0.12;  // of the scene's diagonal: how far ahead of its plane a frustum's aim is drawn

const DrawnFrustum& frustumOfHandle(const DrawnCamera& camera, const FrustumHandle& handle) {
  return *camera.find(handle.frustum);
}

double distanceBehind(const DrawnFrustum& frustum) {
  return glm::distance(frustum.viewpoint, frustum.begins.middle);
}

std::vector<FrustumHandle> viewpointsOf(const DrawnCamera&, const DrawnFrustum& frustum, PlanSide) {
  if (frustum.operation == "root") {
    return {};
  }
  FrustumHandle handle;
  handle.at = frustum.viewpoint;
  return {handle};
}

std::string dragViewpoint(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  return DrawnEdits(camera).viewpoint(handle.frustum, to);
}

/// Rays come from so far behind the plane's middle, along a direction.
std::string lookAlong(const DrawnCamera& camera, const DrawnFrustum& frustum, const glm::dvec3& direction,
                      double distance) {
  const double length = glm::length(direction);
  if (!(length > 0) || !(distance > 0)) {
    throw InputError("the viewpoint would be in the plane of \"" + frustum.name + "\"", "plan",
                     "keep it before the plane");
  }
  return DrawnEdits(camera).viewpoint(frustum.name, frustum.begins.middle - direction * (distance / length));
}

std::vector<HandleNumber> viewpointNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  return {{"distance", "", distanceBehind(frustumOfHandle(camera, handle)), [&camera, handle](double value) {
             const DrawnFrustum& frustum = frustumOfHandle(camera, handle);
             return lookAlong(camera, frustum, frustum.begins.middle - frustum.viewpoint, value);
           }}};
}

std::vector<FrustumHandle> aimsOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide) {
  const glm::dvec3 ahead = frustum.begins.middle - frustum.viewpoint;
  if (frustum.operation == "root" || !(glm::length(ahead) > 0)) {
    return {};
  }
  const double reach =
      std::min(glm::length(ahead), kMaxAimShare * static_cast<double>(glm::length(camera.room.size())));
  FrustumHandle handle;
  handle.at = frustum.begins.middle + glm::normalize(ahead) * reach;
  return {handle};
}

std::string dragAim(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const DrawnFrustum& frustum = frustumOfHandle(camera, handle);
  return lookAlong(camera, frustum, to - frustum.begins.middle, distanceBehind(frustum));
}

std::vector<HandleNumber> aimNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const DrawnFrustum& frustum = frustumOfHandle(camera, handle);
  const glm::dvec3 ahead = frustum.begins.middle - frustum.viewpoint;
  const double heading = headingDegrees(ahead);
  const double pitch = pitchDegrees(ahead);
  const auto look = [&camera, handle](double newHeading, double newPitch) {
    const DrawnFrustum& turned = frustumOfHandle(camera, handle);
    return lookAlong(camera, turned, directionOf(newHeading, newPitch), distanceBehind(turned));
  };
  return {{"heading", "degrees", heading, [=](double value) { return look(value, pitch); }},
          {"pitch", "degrees", pitch, [=](double value) { return look(heading, value); }}};
}

}  // namespace

HandleKind viewpointHandle() {
  return {"viewpoint",     "moves where the rays of the frustum come from",
          Marker::kCircle, viewpointsOf,
          dragViewpoint,   viewpointNumbers};
}

HandleKind aimHandle() {
  return {"aim",     "turns the rays of the frustum about the middle of its plane", Marker::kDiamond, aimsOf, dragAim,
          aimNumbers};
}

}  // namespace ocelli
