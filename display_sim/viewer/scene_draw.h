// Draws meshes, their vertices, and lines, as a pinhole sees them. Colours of lines are sRGB.
#pragma once

#include <vector>

#include "display_sim/viewer/colored_line.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Depths that are drawn.
struct DepthRange {
  float nearest = 0;
  float farthest = 0;
};

/// What holds all of `box` that the camera can have an image of.
DepthRange depthRange(const PinholeCamera& camera, const Box& box);

/// Sets the uniforms of view.glsl.
void setView(const GladGLContext& gl, const GlObject& program, const PinholeCamera& camera, const DepthRange& range);

/// Into the bound framebuffer, whose second image may take the points in space. Hold a GlScope, here and below.
class MeshDraw {
 public:
  explicit MeshDraw(GlContext& context);
  void draw(const GlMesh& mesh, const PinholeCamera& camera, const DepthRange& range);
  /// Its vertices, as squares of so many pixels.
  void drawVertices(const GlMesh& mesh, const PinholeCamera& camera, const DepthRange& range, float pixels);

 private:
  GlContext* context_;
  GlObject program_;
};

class LineDraw {
 public:
  explicit LineDraw(GlContext& context);
  /// Blended onto the bound framebuffer of this size in order. Those behind what stands in its depth buffer are drawn
  /// with their opacity times `hidden`.
  void draw(const std::vector<ColoredLine>& lines, const PinholeCamera& camera, const DepthRange& range, float hidden);

 private:
  GlContext* context_;
  GlObject program_;
  GlObject vertexArray_;
};

}  // namespace ocelli
