// Where an eye before a display is as a trial goes on: a head that sways about the display, or that was recorded. The
// eye looks at the display's centre all the time. It is at one of a few poses at any tick, so that a screen has an
// image of each of them beforehand; between poses nothing is interpolated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"

namespace ocelli {

class JsonFields;

/// Where representations are made that the display shows.
enum class MadeAt : uint8_t {
  kRest,  ///< from where the eye rests: once
  kEach,  ///< from each pose of the eye: what a display would show that knows where the eye is
};
const char* nameOf(MadeAt madeAt);

class HeadMotion {
 public:
  /// The eye rests.
  HeadMotion() = default;

  /// The field "head": an object with "sway_degrees", "seconds", "axis" and "images", or with "poses" and "images".
  /// Poses are those of eye_path.h: in radii of the display, the task's eye at +z. Throws InputError naming the field,
  /// for a pose in the display too.
  static HeadMotion read(JsonFields& fields, const DisplayProfile& profile);

  bool moves() const { return !offsets_.empty() || !eyes_.empty(); }
  size_t poseCount() const;
  /// Of the pose with that index, in the display's coordinates, for an eye that rests at `rest`.
  glm::vec3 eyeOf(size_t pose, const glm::vec3& rest) const;
  /// The pose at a tick of a trial. A sway begins at rest, to the right or upwards; it is at the pose nearest to its
  /// sine. A recorded head stays at its last pose.
  size_t poseAt(int64_t tick) const;

 private:
  double seconds_ = 0;             ///< of a period, or of the recording
  bool vertical_ = false;          ///< sways up and down
  std::vector<double> offsets_{};  ///< of a sway: angles about the display's centre, radians, from one end to the other
  std::vector<glm::vec3> eyes_{};  ///< of a recording, at equal intervals
};

}  // namespace ocelli
