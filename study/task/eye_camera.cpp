#include "study/task/eye_camera.h"

#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/task/task_layout.h"

namespace ocelli {

EyeCamera::EyeCamera(const Maze& maze, const Controls& controls, const EyeCameraOptions& options,
                     StudyConditions conditions)
    : options_(options),
      conditions_(std::move(conditions)),
      eyeHeight_(static_cast<double>(maze.origin.y) + controls.eyeHeightMeters),
      // Walls are never nearer than the body's radius: the corners of the near rectangle stay before them.
      zNear_(controls.bodyRadiusMeters / 5) {
  guides_.maze = maze;
  guides_.maze->landmarks.clear();
}

PinholeCamera EyeCamera::pinhole(const WalkerPose& pose, const glm::ivec2& size) const {
  const Maze& maze = *guides_.maze;
  View view;
  view.eye = glm::vec3(glm::dvec3(pose.x, eyeHeight_, pose.z));
  view.target = view.eye + glm::vec3(glm::dvec3(std::sin(pose.headingRadians), 0, -std::cos(pose.headingRadians)));
  const double tangent = std::tan(radiansFromDegrees(options_.fovHorizontalDegrees) / 2);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(tangent * size.y / size.x));
  view.zNear = static_cast<float>(zNear_);
  view.zFar = maze.cellSize * static_cast<float>(4 * (maze.rows() + maze.columns()));
  return {view, size.x, size.y};
}

std::optional<GraphCamera> EyeCamera::portalCamera(const WalkerPose& pose, const glm::ivec2& size) const {
  try {
    return buildPortalCamera(options_.portals, guides_, pinhole(pose, size));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<TrialLayout::View> EyeCamera::views(const WalkerPose& pose, TrialView view, const PixelRect& place) const {
  const PinholeCamera eye = pinhole(pose, sizeOf(place));
  const auto graph = [&]() -> std::vector<TrialLayout::View> {
    std::vector<TrialLayout::View> views;
    views.emplace_back(place, portalCamera(pose, sizeOf(place)).value_or(GraphCamera(eye)));
    return views;
  };
  return conditions_.viewsOf(view, {{{place, eye}}, graph});
}

EyeCameraOptions readEyeCameraOptions(JsonFields& fields) {
  EyeCameraOptions options;
  options.fovHorizontalDegrees = fields.number("fov_horizontal_degrees", 10, 150, options.fovHorizontalDegrees);
  if (fields.has("portals")) {
    JsonFields portals = fields.inner("portals");
    options.portals = readPortalOptions(portals, options.portals);
    portals.rejectUnknown();
    if (!options.portals.portals.empty()) {
      portals.fail("portals", "is a list for one place of the eye, but who walks sees the openings of the maze");
    }
  }
  return options;
}

}  // namespace ocelli
