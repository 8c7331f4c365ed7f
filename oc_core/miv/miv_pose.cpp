#include "oc_core/miv/miv_pose.h"

#include <cmath>
#include <glm/mat3x3.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

glm::dvec3 mivFromWorld(const glm::dvec3& v) {
  return {-v.z, -v.x, v.y};
}
glm::dvec3 worldFromMiv(const glm::dvec3& v) {
  return {-v.y, v.z, -v.x};
}

/// Columns are the camera's forward, left and up.
glm::dmat3 rotationMatrix(const std::array<double, 3>& degrees) {
  const double yaw = radiansFromDegrees(degrees[0]);
  const double pitch = radiansFromDegrees(degrees[1]);
  const double roll = radiansFromDegrees(degrees[2]);
  const glm::dmat3 aboutUp{{std::cos(yaw), std::sin(yaw), 0}, {-std::sin(yaw), std::cos(yaw), 0}, {0, 0, 1}};
  const glm::dmat3 aboutLeft{{std::cos(pitch), 0, -std::sin(pitch)}, {0, 1, 0}, {std::sin(pitch), 0, std::cos(pitch)}};
  const glm::dmat3 aboutForward{{1, 0, 0}, {0, std::cos(roll), std::sin(roll)}, {0, -std::sin(roll), std::cos(roll)}};
  return aboutUp * aboutLeft * aboutForward;
}

}  // namespace

MivPose mivPose(const PinholeCamera& camera, double unitsPerMetre) {
  const glm::dvec3 position = mivFromWorld(glm::dvec3(camera.eye()) / unitsPerMetre);
  const glm::dvec3 forward = mivFromWorld(glm::normalize(glm::dvec3(camera.forward())));
  const glm::dvec3 left = mivFromWorld(-glm::normalize(glm::dvec3(camera.right())));
  const glm::dvec3 up = mivFromWorld(-glm::normalize(glm::dvec3(camera.down())));
  constexpr double kLevel = 1e-9;  // of the cosine of the pitch: straight up or down, yaw and roll are one
  const double across = std::hypot(forward.x, forward.y);
  const double pitch = std::atan2(-forward.z, across);
  const double yaw = across > kLevel ? std::atan2(forward.y, forward.x) : std::atan2(-left.x, left.y);
  const double roll = across > kLevel ? std::atan2(left.z, up.z) : 0;
  return {{position.x, position.y, position.z},
          {degreesFromRadians(yaw), degreesFromRadians(pitch), degreesFromRadians(roll)}};
}

View viewOfMivPose(const MivPose& pose, double unitsPerMetre, const View& otherwise) {
  const glm::dmat3 axes = rotationMatrix(pose.rotation);
  const glm::dvec3 eye = worldFromMiv({pose.position[0], pose.position[1], pose.position[2]}) * unitsPerMetre;
  View view = otherwise;
  view.eye = eye;
  view.target = eye + worldFromMiv(axes[0]) * unitsPerMetre;
  view.up = worldFromMiv(axes[2]);
  return view;
}

}  // namespace ocelli
