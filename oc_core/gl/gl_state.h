// What the passes of the renderer set before they draw or compute. Each sets all it relies on, and relies on nothing
// that another has left.
#pragma once

#include "oc_core/gl/gl_mesh.h"
#include "oc_core/gl/gl_object.h"

namespace ocelli {

/// Draws with a depth that shrinks with the distance (clipFromCamera() of shaders/pinhole.glsl), to a framebuffer whose
/// depth this clears; both sides of triangles; the first of equal depths stays.
void beginDepthDraw(GlContext& context, const GlObject& framebuffer, int width, int height);

/// Buffers as shaders/mesh.glsl takes them.
void bindMesh(GlContext& context, const GlMesh& mesh);

/// Runs the bound compute shader, of groups of 8x8, over an image, and lets what follows see what it wrote.
void dispatchPixels(GlContext& context, int width, int height);

}  // namespace ocelli
