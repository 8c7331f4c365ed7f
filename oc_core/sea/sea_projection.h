// How the images of a sea are taken: which direction each pixel looks into, seen from the eye of an image.
//
// Directions are in the axes of the camera: x to the right, y up, -z forward. Pixels as conventions.h has them.
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace ocelli {

/// The kinds of projections that files know, by their numbers there.
enum class SeaProjectionKind : uint8_t {
  kPanorama = 0,  ///< equirectangular, 360 by 180 degrees, as panorama_camera.h has it
  kPinhole = 1,   ///< of one focal length for each axis, without lens distortion
};

struct SeaProjection {
  SeaProjectionKind kind = SeaProjectionKind::kPanorama;
  int width = 1024;
  int height = 1024;
  glm::dvec2 focal{1};   ///< of a pinhole, pixels
  glm::dvec2 center{0};  ///< of a pinhole: where -z meets the image, pixels

  /// The last column is next to the first.
  bool wraps() const { return kind == SeaProjectionKind::kPanorama; }
  /// A unit vector.
  glm::vec3 direction(const glm::vec2& pixel) const;
  /// Where a direction (any length but 0) is seen. Of a panorama everything is; of a pinhole what lies in front of it,
  /// within the image or not.
  std::optional<glm::vec2> pixel(const glm::vec3& direction) const;
  /// The same at `share` of the resolution.
  SeaProjection scaled(double share) const;
  /// In radians, about, at the middle of the image.
  double pixelAngle() const;

  bool operator==(const SeaProjection&) const = default;
};

/// Throws InputError naming `where` for sizes that no codec takes, and for focal lengths that are not positive.
void validate(const SeaProjection& projection, const std::string& where);

/// Where an image was taken, and how the camera stood there.
struct SeaPose {
  glm::dvec3 position{0};
  glm::dquat worldFromCamera{1, 0, 0, 0};

  bool operator==(const SeaPose&) const = default;
};

/// How an image was taken, and where.
struct SeaCamera {
  SeaProjection projection;
  SeaPose pose;
};

/// The pose whose offsets in the axes of `pose` are these: a translation, and a rotation as axis times angle.
SeaPose movedBy(const SeaPose& pose, const glm::dvec3& translation, const glm::dvec3& rotation);

}  // namespace ocelli
