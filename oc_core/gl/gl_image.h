// Textures as images in memory.
#pragma once

#include "oc_core/gl/gl_object.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

/// Of a GL_RGBA8 texture of that size, whose row 0 is the top: its values without alpha. Hold a GlScope. Throws
/// GlError.
Image<Rgb8> readRgb8(GlContext& context, const GlObject& texture, int width, int height);

}  // namespace ocelli
