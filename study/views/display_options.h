// What a view of kind "display" is told, and where the display stands.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "display_sim/frames/display_profile.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "study/views/head_motion.h"

namespace ocelli {

struct DisplayViewOptions {
  DisplayProfile profile;
  double distanceMeters = 6;  ///< from the eye to the display's centre
  double radiusMeters = 3;    ///< of the scene that the display's radius stands for
  std::optional<CameraChoice> camera{};
  HeadMotion head{};
  MadeAt madeAt = MadeAt::kRest;
  /// Of the image of the eye at rest, the share of white that its pixels send on average; where missing the gain is
  /// automaticGain() of that image. Either holds for all poses of the eye.
  std::optional<double> meanLuminance{};
  int imageRows = 0;  ///< of the observer's image, which is scaled to its place; 0: as many as the place has
};

/// The display's coordinates for an eye that rests at a pinhole: its radius is 1, y up, the eye on the side of +z.
class DisplayFrame {
 public:
  DisplayFrame(const PinholeCamera& camera, const DisplayViewOptions& options)
      : center_(camera.eye() + static_cast<float>(options.distanceMeters) * camera.forward()),
        radius_(static_cast<float>(options.radiusMeters)),
        right_(glm::normalize(glm::cross(camera.forward(), glm::vec3(0, 1, 0)))),
        back_(glm::cross(right_, glm::vec3(0, 1, 0))) {}

  const glm::vec3& center() const { return center_; }
  glm::vec3 fromWorld(const glm::vec3& point) const {
    const glm::vec3 p = (point - center_) / radius_;
    return {glm::dot(p, right_), p.y, glm::dot(p, back_)};
  }
  glm::vec3 toWorld(const glm::vec3& point) const {
    return center_ + radius_ * (point.x * right_ + point.y * glm::vec3(0, 1, 0) + point.z * back_);
  }

 private:
  glm::vec3 center_;
  float radius_;
  glm::vec3 right_;
  glm::vec3 back_;
};

}  // namespace ocelli
