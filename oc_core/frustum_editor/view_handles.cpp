// Handles of the root: its view.
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/frustum_editor/drawn_edits.h"
#include "oc_core/frustum_editor/handle_list.h"
#include "oc_core/frustum_editor/plan_turns.h"

namespace ocelli {
namespace {

constexpr double kMinFovDegrees = 1;
constexpr double kMaxFovDegrees = 170;

bool isRootFrustum(const DrawnFrustum& frustum) {
  return frustum.operation == "root";
}

const PinholeCamera& rootOf(const DrawnCamera& camera) {
  return std::visit([](const auto& each) -> const PinholeCamera& { return each.root(); }, *camera.camera);
}

std::string fovEdit(const DrawnCamera& camera, double degrees) {
  if (!(degrees >= kMinFovDegrees && degrees <= kMaxFovDegrees)) {
    throw InputError("the field of view would be outside of 1 to 170 degrees", "root", "drag its border elsewhere");
  }
  View view = camera.view;
  view.fovVerticalDegrees = roundedTo(degrees, 0.01);
  return DrawnEdits(camera).view(view);
}

/// A border of the image as far away as the target: the right one from above, else the upper one.
glm::dvec3 borderDirection(const DrawnCamera& camera, PlanSide side) {
  const PinholeCamera& root = rootOf(camera);
  return side == PlanSide::kTop ? glm::dvec3(root.right()) : -glm::dvec3(root.down());
}

double targetDistance(const DrawnCamera& camera) {
  return static_cast<double>(glm::distance(camera.view.target, camera.view.eye));
}

std::vector<FrustumHandle> eyesOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide) {
  if (!isRootFrustum(frustum)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = glm::dvec3(camera.view.eye);
  return {handle};
}

std::string dragEye(const DrawnCamera& camera, const FrustumHandle&, const glm::dvec3& to) {
  View view = camera.view;
  // A field of view of 0 is one that the distance decides: it stays as it is seen.
  view.fovVerticalDegrees = camera.view.resolvedFovVerticalDegrees();
  view.eye = glm::vec3(to);
  return DrawnEdits(camera).view(view);
}

std::vector<FrustumHandle> targetsOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide) {
  if (!isRootFrustum(frustum)) {
    return {};
  }
  FrustumHandle handle;
  handle.at = glm::dvec3(camera.view.target);
  return {handle};
}

std::string dragTarget(const DrawnCamera& camera, const FrustumHandle&, const glm::dvec3& to) {
  View view = camera.view;
  view.fovVerticalDegrees = camera.view.resolvedFovVerticalDegrees();
  view.target = glm::vec3(to);
  return DrawnEdits(camera).view(view);
}

std::vector<HandleNumber> targetNumbers(const DrawnCamera& camera, const FrustumHandle& handle) {
  const glm::dvec3 eye(camera.view.eye);
  const glm::dvec3 ahead = handle.at - eye;
  const double distance = glm::length(ahead);
  const double heading = headingDegrees(ahead);
  const double pitch = pitchDegrees(ahead);
  const auto look = [&camera, handle, eye, distance](double newHeading, double newPitch) {
    return dragTarget(camera, handle, eye + directionOf(newHeading, newPitch) * distance);
  };
  return {{"heading", "degrees", heading, [=](double value) { return look(value, pitch); }},
          {"pitch", "degrees", pitch, [=](double value) { return look(heading, value); }}};
}

std::vector<FrustumHandle> fieldsOfViewOf(const DrawnCamera& camera, const DrawnFrustum& frustum, PlanSide side) {
  if (!isRootFrustum(frustum)) {
    return {};
  }
  const double halfHeight =
      std::tan(radiansFromDegrees(camera.view.resolvedFovVerticalDegrees()) / 2) * targetDistance(camera);
  const double reach = side == PlanSide::kTop ? halfHeight * camera.imageSize().x / camera.imageSize().y : halfHeight;
  FrustumHandle handle;
  handle.at = glm::dvec3(camera.view.target) + borderDirection(camera, side) * reach;
  return {handle};
}

std::string dragFieldOfView(const DrawnCamera& camera, const FrustumHandle& handle, const glm::dvec3& to) {
  const glm::dvec3 offset = to - glm::dvec3(camera.view.eye);
  const double ahead = glm::dot(offset, glm::dvec3(rootOf(camera).forward()));
  double beside = glm::dot(offset, borderDirection(camera, handle.side));
  if (handle.side == PlanSide::kTop) {
    beside *= camera.imageSize().y / camera.imageSize().x;
  }
  return fovEdit(camera, 2 * degreesFromRadians(std::atan2(beside, ahead)));
}

std::vector<HandleNumber> fieldOfViewNumbers(const DrawnCamera& camera, const FrustumHandle&) {
  return {{"field of view", "degrees", camera.view.resolvedFovVerticalDegrees(),
           [&camera](double value) { return fovEdit(camera, value); }}};
}

}  // namespace

HandleKind eyeHandle() {
  return {"eye", "moves the viewpoint of the root", Marker::kCircle, eyesOf, dragEye};
}

HandleKind targetHandle() {
  return {"target", "aims the root", Marker::kDiamond, targetsOf, dragTarget, targetNumbers};
}

HandleKind fieldOfViewHandle() {
  return {"field of view",   "widens or narrows the root", Marker::kTriangle, fieldsOfViewOf, dragFieldOfView,
          fieldOfViewNumbers};
}

}  // namespace ocelli
