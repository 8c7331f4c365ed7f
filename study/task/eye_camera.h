// What someone sees who walks in a maze: a pinhole at the eye, or the graph camera that the portal-based constructor
// (sections 4.3.1.1 and 7.2) makes of it.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/constructor/portal_constructor.h"
#include "study/task/task.h"

namespace ocelli {

class JsonFields;

struct EyeCameraOptions {
  double fovHorizontalDegrees = 70;
  PortalOptions portals{};  ///< its list of portals is empty: they are the openings of the maze
};

class EyeCamera {
 public:
  EyeCamera(const Maze& maze, const Controls& controls, const EyeCameraOptions& options);

  PinholeCamera pinhole(const WalkerPose& pose, const glm::ivec2& size) const;
  /// Nothing where the constructor refuses the pose.
  std::optional<GraphCamera> portalCamera(const WalkerPose& pose, const glm::ivec2& size) const;
  /// Of either kind. A pose that the portal-based constructor refuses shows the pinhole.
  StudyCamera at(const WalkerPose& pose, StudyView view, const glm::ivec2& size) const;

 private:
  SceneGuides guides_;
  EyeCameraOptions options_;
  double eyeHeight_;
  double zNear_;
};

/// The fields "fov_horizontal_degrees" and "portals" of a block. Throws InputError naming the field.
EyeCameraOptions readEyeCameraOptions(JsonFields& fields);

}  // namespace ocelli
