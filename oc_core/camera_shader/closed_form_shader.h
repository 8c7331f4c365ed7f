// Cameras whose rays a shader computes by a formula: those that are made from the view and a few numbers. All others
// are read from a texture: ray_texture_shader.h.
//
// Recipe for another closed form: a row in closed_form_shader.cpp, and a case in
// tests/camera_shader/shader_cases.cpp, which compares its rays.
#pragma once

#include <span>
#include <string>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct ClosedForm {
  const char* kind;  ///< the name of the representation whose camera it is (representation_kind.h)
  /// Statements of the shader that set position and direction. Names for them: width, height, begin (the distance at
  /// which rays begin), x and y: the place in the image in pixels from the top left, as those of PinholeCamera.
  std::string (*statements)(const CameraChoice& choice, const PinholeCamera& reference);
};
std::span<const ClosedForm> closedForms();
/// Nothing for cameras without one.
const ClosedForm* findClosedForm(const CameraChoice& choice);

/// The shader's text (osl_text.h). Rays begin where those of the camera do, at the near distance of the view.
std::string closedFormShader(const ClosedForm& form, const CameraChoice& choice, const PinholeCamera& reference);

}  // namespace ocelli
