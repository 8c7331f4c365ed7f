// Any camera of straight rays as a shader that reads them from a texture, one ray a pixel.
//
// The texture is an OpenEXR file of the channels R, G, B, of 32-bit float, as wide as the image and twice as high: the
// upper half holds where each ray begins, the lower half its direction, a unit vector, or (0, 0, 0) where a pixel has
// no ray; both in the space of the camera (osl_text.h). It is no ray map: renderers agree about where R, G and B of a
// file are, and not about channels of other names, and some keep four channels at most.
//
// The shader asks for the centre of a texel without filtering. Renderers that filter all the same, as Cycles does where
// it keeps textures itself, give that texel too.
#pragma once

#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/camera/ray_map.h"

namespace ocelli {

/// Throws InputError where rays bend: a camera of a renderer has one straight ray a pixel.
void requireStraightRays(const RayMap& map);

/// The shader's text; `texture` is where the file of rayTextureBytes() lies, which the shader's parameter `rays` says.
std::string rayTextureShader(const RayMap& map, const std::string& texture);

/// Both throw as requireStraightRays() does.
std::string rayTextureBytes(const RayMap& map, const Progress& progress = {});

}  // namespace ocelli
