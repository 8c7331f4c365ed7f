// The pinhole camera as shaders/pinhole.glsl takes it.
#pragma once

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

/// A uniform buffer for binding 0. Hold a GlScope.
GlObject pinholeUniforms(GlContext& context, const PinholeCamera& camera);

}  // namespace ocelli
