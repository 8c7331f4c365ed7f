// The text of a camera shader in the Open Shading Language (OSL), as Cycles of Blender takes it: "Custom Camera" of the
// Blender manual, and camera_sample_custom() of Cycles.
//
// The shader gets the place in the image from camera_shader_raster_position(): x from 0 at the left to 1 at the right,
// y from 0 at the bottom to 1 at the top, so that the centre of pixel (i, j), from the top left, is at
// ((i + 0.5) / width, 1 - (j + 0.5) / height). It gives position, direction (a unit vector) and throughput (0: no ray)
// in the space of the camera: x to the right, y up, z forward, which is left-handed; the unit is that of the scene.
//
// Texts keep to what is both OSL and C++ with a few types and functions: tests/camera_shader runs them so. Expressions
// have no numbers with a point, so that all of them are of single precision in both.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

#include "oc_core/camera/view.h"

namespace ocelli {

struct OslCamera {
  std::string name;          ///< what people call it
  glm::ivec2 size{0};        ///< of its image, pixels
  std::optional<View> view;  ///< where it stands; nothing for a lens that can be put anywhere
  std::string remarks;       ///< lines of comment, which end in line breaks; may be empty
  std::string parameters;    ///< lines of the shader's own parameters, each with a comma before it; may be empty
  std::string statements;    ///< what sets position, direction and throughput
};
std::string oslText(const OslCamera& camera);

/// A literal of single precision.
std::string oslNumber(double value);
/// "    float name = value;  // meaning" and a line break.
std::string oslFloat(const std::string& name, double value, const std::string& meaning = "");
/// The same of an array, which has one value or more.
std::string oslFloats(const std::string& name, std::span<const double> values, const std::string& meaning = "");
/// In quotes, with what needs it escaped.
std::string oslString(const std::string& text);

/// From the world into the space of the camera, of a view.
class OslCameraSpace {
 public:
  explicit OslCameraSpace(const View& view);
  glm::dvec3 direction(const glm::dvec3& world) const;
  glm::dvec3 point(const glm::dvec3& world) const { return direction(world - eye_); }

 private:
  glm::dvec3 eye_;
  glm::dvec3 right_;
  glm::dvec3 up_;
  glm::dvec3 forward_;
};

}  // namespace ocelli
