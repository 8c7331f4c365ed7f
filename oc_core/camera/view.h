// A view: where the eye is, where it looks, and how wide. The JSON form is what `--view FILE.json` takes.
#pragma once

#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "oc_core/base/conventions.h"

namespace ocelli {

struct View {
  glm::vec3 eye{0, 0, kDefaultEyeDistance};
  glm::vec3 target{0, 0, 0};
  glm::vec3 up{0, 1, 0};
  double fovVerticalDegrees = 0;  ///< 0 stands for "just holds the unit sphere around the target"
  float zNear = 0.01f;            ///< nearest distance along the view direction that has an image
  float zFar = 1000.0f;
  /// Where the view direction meets the image, from its middle, to the right and down, in image heights: a sheared
  /// frustum, whose image plane stays as it is while it looks to the side.
  glm::vec2 centerShift{0};

  /// The vertical field of view with the 0 resolved: 2 asin(1 / distance). At least one unit away from the target.
  double resolvedFovVerticalDegrees() const;

  bool operator==(const View&) const = default;
};

/// Throws InputError where eye and target coincide, up is parallel to the direction, a number is not finite, the field
/// of view is not in (0, 179) degrees, the shift is beyond 10 image heights, the eye is within the unit sphere while no
/// field of view is given, or zNear is not positive and less than zFar.
void validate(const View& view, const std::string& where);

View readView(const std::filesystem::path& path);
View viewFromJsonText(const std::string& text, const std::string& where);
std::string jsonText(const View& view);

/// The same view with its eye moved by `offset`, given along (right, up, backward) of the view; it looks at the same
/// target.
View movedEye(const View& view, const glm::vec3& offset);

}  // namespace ocelli
