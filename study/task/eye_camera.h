// What someone sees who walks in a maze, in each condition of a study: made of a pinhole at the eye, and of the graph
// camera that the portal-based constructor (sections 4.3.1.1 and 7.2) makes of it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/constructor/portal_constructor.h"
#include "study/outline/usual_values.h"
#include "study/task/task.h"

namespace ocelli {

class JsonFields;

struct EyeCameraOptions {
  double fovHorizontalDegrees = kUsualFovHorizontalDegrees;
  /// Its list of portals is empty: they are the openings of the maze. Studies stay on the curve that they began with,
  /// so that stored trials replay as they were.
  PortalOptions portals = portalCurve("band");
};

class EyeCamera {
 public:
  EyeCamera(const Maze& maze, const Controls& controls, const EyeCameraOptions& options,
            StudyConditions conditions = {});

  const StudyConditions& conditions() const { return conditions_; }
  PinholeCamera pinhole(const WalkerPose& pose, const glm::ivec2& size) const;
  /// Nothing where the constructor refuses the pose.
  std::optional<GraphCamera> portalCamera(const WalkerPose& pose, const glm::ivec2& size) const;
  /// The views of a condition, all within `place`. Where the portal-based constructor refuses the pose, the pinhole
  /// stands for the graph camera.
  std::vector<TrialLayout::View> views(const WalkerPose& pose, TrialView view, const PixelRect& place) const;

 private:
  SceneGuides guides_;
  EyeCameraOptions options_;
  StudyConditions conditions_;
  double eyeHeight_;
  double zNear_;
};

/// The fields "fov_horizontal_degrees" and "portals" of a block. Throws InputError naming the field.
EyeCameraOptions readEyeCameraOptions(JsonFields& fields);

}  // namespace ocelli
