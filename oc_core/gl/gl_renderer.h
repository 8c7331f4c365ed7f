// The renderer of section 6 on the GPU: what every camera sees of a mesh that is uploaded once. The fragments are those
// of the renderers in oc_core/render, but for rounding at silhouettes; OpenGL 4.5 is enough.
//
// Pinhole cameras are drawn as they are. Cameras that displace the image of a pinhole are drawn by subdivision, the
// epipolar camera by spans of epipolar lines: as on the CPU, since the reasons are the same (a ray that bends has
// no projective map), with compute shaders in place of threads. Graph and curved ray cameras are drawn one piece of
// their rays after the other.
#pragma once

#include <memory>

#include "oc_core/gl/gl_fragments.h"
#include "oc_core/gl/gl_mesh.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {

class GlRenderer final : public SceneRenderer {
 public:
  /// Throws GlError where the GPU has no room for the mesh, or its driver refuses a shader. The context must outlive
  /// it.
  GlRenderer(GlContext& context, const Mesh& mesh);
  ~GlRenderer() override;

  GlContext& context() const { return context_; }
  const GlMesh& mesh() const;

  /// Another mesh in place of the one before; much faster than another renderer. Throws GlError where the GPU has no
  /// room.
  void setMesh(const Mesh& mesh);
  /// So many vertices from `first` on stand where `moved` has them, which is otherwise the mesh that was given before:
  /// nothing else is uploaded.
  void moveVertices(const Mesh& moved, size_t first, size_t count);

  /// The closest fragment at each pixel, as on the CPU. Throws GlError where the GPU fails.
  FragmentImage draw(const PinholeCamera& camera) const override;
  FragmentImage draw(const SpocCamera& camera) const override;
  FragmentImage draw(const ReversePinholeCamera& camera) const override;
  FragmentImage draw(const GpcCamera& camera) const override;
  FragmentImage draw(const DdocCamera& camera, const FragmentImage& seen,
                     const SubdivisionOptions& subdivision) const override;
  FragmentImage drawLines(const PinholeCamera& base, const EpipolarLines& lines) const override;
  FragmentImage draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const override;
  FragmentImage draw(const GraphCamera& camera) const override;
  FragmentImage draw(const CurvedRayCamera& camera) const override;

  /// The same, left on the GPU; cameras that need what their pinhole sees draw that as well. Hold a GlScope, here and
  /// below.
  GlFragments drawOnGpu(const PinholeCamera& camera) const;
  GlFragments drawOnGpu(const SpocCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments drawOnGpu(const ReversePinholeCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments drawOnGpu(const GpcCamera& camera) const;
  GlFragments drawOnGpu(const DdocCamera& camera, const SubdivisionOptions& options = {}) const;
  GlFragments drawOnGpu(const EpipolarCamera& camera) const;
  GlFragments drawOnGpu(const GraphCamera& camera) const;
  GlFragments drawOnGpu(const CurvedRayCamera& camera) const;
  GlFragments drawLinesOnGpu(const PinholeCamera& base, const EpipolarLines& lines) const;

  /// Linear colours as a texture of GL_RGBA32F, `background` where nothing is seen; alpha says which.
  GlObject colors(const GlFragments& fragments, const glm::vec3& background) const;
  /// The same as sRGB values in an opaque texture of GL_RGBA8; `background` is linear too.
  GlObject encodedColors(const GlFragments& fragments, const glm::vec3& background) const;

 private:
  struct Impl;
  GlObject resolve(const GlObject& program, uint32_t format, const GlFragments& fragments,
                   const glm::vec3& background) const;

  GlContext& context_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
