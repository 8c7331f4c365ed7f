// The OpenGL functions and constants, for .cpp files: `context.gl().DrawArrays(GL_TRIANGLES, 0, 3)`.
#pragma once

#include <glad/gl.h>

#include "oc_core/gl/gl_context.h"
