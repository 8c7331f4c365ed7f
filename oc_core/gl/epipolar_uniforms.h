// Epipolar lines and disocclusions as shaders/epipolar_lines.glsl and epipolar_disocclusions.glsl take them.
#pragma once

#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

class EpipolarUniforms {
 public:
  /// How far beyond the image borders a vertex may project before its triangle is clipped, pixels.
  static constexpr float kClipMargin = 4096;

  /// Lines without disocclusions. Hold a GlScope, here and below.
  EpipolarUniforms(GlContext& context, const PinholeCamera& base, const EpipolarLines& lines);
  EpipolarUniforms(GlContext& context, const EpipolarCamera& camera);

  void bind(GlContext& context) const;

 private:
  GlObject pinhole_;
  GlObject lines_;
  GlObject rows_;
  GlObject disocclusions_;
  GlObject over_;
};

}  // namespace ocelli
