// The renderer of section 6 on the GPU: what every camera sees of a mesh that is uploaded once. The fragments are those
// of the renderers in oc_core/render, but for rounding at silhouettes; OpenGL 4.5 is enough.
//
// Pinhole cameras are drawn as they are. Cameras that displace the image of a pinhole are drawn by subdivision, the
// epipolar camera by spans of epipolar lines: as on the processor, since the reasons are the same (a ray that bends has
// no projective map), with compute shaders in place of threads.
#pragma once

#include <memory>

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/render/rasterize_subdivided.h"

namespace ocelli {

class GlRenderer {
 public:
  /// Throws GlError where the GPU has no room for the mesh, or its driver refuses a shader. The context must outlive
  /// it.
  GlRenderer(GlContext& context, const Mesh& mesh);
  ~GlRenderer();

  GlContext& context() const { return context_; }
  const GlMesh& mesh() const;

  /// The closest fragment at each pixel, as on the processor. Throws GlError where the GPU fails.
  FragmentImage render(const PinholeCamera& camera) const;
  FragmentImage render(const SpocCamera& camera, const SubdivisionOptions& options = {}) const;
  FragmentImage render(const ReversePinholeCamera& camera, const SubdivisionOptions& options = {}) const;
  FragmentImage render(const DdocCamera& camera, const SubdivisionOptions& options = {}) const;
  FragmentImage render(const EpipolarCamera& camera) const;

  /// The same, left on the GPU. Hold a GlScope, here and below.
  GlFragments draw(const PinholeCamera& camera) const;
  GlFragments draw(const SpocCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments draw(const ReversePinholeCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments draw(const DdocCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments draw(const EpipolarCamera& camera) const;

  /// What `base` sees along its epipolar lines (oc_core/render/rasterize_spans.h).
  GlFragments drawLines(const PinholeCamera& base, const EpipolarLines& lines) const;

  /// Linear colours as a texture of GL_RGBA32F, `background` where nothing is seen; alpha says which.
  GlObject colors(const GlFragments& fragments, const glm::vec3& background) const;

 private:
  struct Impl;

  GlContext& context_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
