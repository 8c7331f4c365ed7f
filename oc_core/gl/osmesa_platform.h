// Contexts of OSMesa, Mesa's software renderer that draws into memory.
#pragma once

#include <memory>

#include "oc_core/gl/gl_context.h"

namespace ocelli {

/// Throws GlError where OSMesa is not installed or has no OpenGL 4.5.
std::unique_ptr<GlPlatform> openOsMesaPlatform();

}  // namespace ocelli
