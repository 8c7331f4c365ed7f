// Volumes along the rays of any camera with OpenGL 4.5: what oc_core/volume_render/volume_renderer.h computes, at the
// same samples, with the same tables, in single precision. Pixels differ by rounding alone, but where hardware filters
// the voxels (GlVolumeFilter).
//
// The rays of planar and general pinholes are made and cut by the shader. Those of other cameras, and those that can
// end at a surface, are made and cut on the CPU, and uploaded some rows of the image at a time.
#pragma once

#include <concepts>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/camera/camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/gl/gl_object.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/volume_render/volume_image.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

/// How the field between voxels is computed.
enum class GlVolumeFilter {
  kExact,     ///< by the shader, from eight voxels
  kHardware,  ///< by the GPU's texture units: faster there, but their weights may have no more than 8 bits
};

class GlVolumeRenderer {
 public:
  /// Uploads all voxels. Throws GlError where the volume is too large for the context's 3-D textures or its memory, or
  /// the driver refuses a shader; so do the functions below where the GPU fails. `progress` may throw. The context must
  /// outlive it.
  GlVolumeRenderer(GlContext& context, VolumeScene scene, const VolumeRenderOptions& options = {},
                   GlVolumeFilter filter = GlVolumeFilter::kExact, const Progress& progress = {});
  ~GlVolumeRenderer();
  GlVolumeRenderer(const GlVolumeRenderer&) = delete;
  GlVolumeRenderer& operator=(const GlVolumeRenderer&) = delete;

  GlContext& context() const;
  const VolumeScene& scene() const;
  const VolumeRenderOptions& options() const;
  /// These upload no voxels: milliseconds, for editors.
  void setAppearance(const VolumeAppearance& appearance);
  void setClips(std::vector<ClipPlane> clips);
  void setOptions(const VolumeRenderOptions& options);

  /// As VolumeRenderer::render() does. `progress` is called on the calling thread, and may throw to end the work.
  VolumeImage render(const PinholeCamera& camera, const Progress& progress = {}) const;
  VolumeImage render(const GpcCamera& camera, const Progress& progress = {}) const;
  VolumeImage render(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                     const Progress& progress = {}) const;

  /// The same, left on the GPU. Hold a GlScope, here and below.
  struct Picture {
    GlObject colors;  ///< GL_RGBA32F, row 0 at the top: linear RGB, premultiplied, and the opacity
    /// GL_RGBA32F: t and surfaceT of VolumePixel, 3e38 for nowhere; samples; the optical depth of what lies before a
    /// surface.
    GlObject depths;
  };
  Picture drawOnGpu(const PinholeCamera& camera, const Progress& progress = {}) const;
  Picture drawOnGpu(const GpcCamera& camera, const Progress& progress = {}) const;
  Picture drawOnGpu(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                    const Progress& progress = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a camera sees of a volume: renderVolume() of volume_renderer.h with OpenGL.
template <Camera C>
VolumeImage renderVolumeOnGpu(const C& camera, const GlVolumeRenderer& renderer, const Progress& progress = {}) {
  if constexpr (std::same_as<C, PinholeCamera> || std::same_as<C, GpcCamera>) {
    return renderer.render(camera, progress);
  } else {
    return renderer.render(
        camera.width(), camera.height(), [&](const glm::vec2& pixel) { return camera.rayPath(pixel); }, progress);
  }
}

}  // namespace ocelli
