// Volumes along rays on the GPU, where there is one that holds them, and else on the CPU: for windows, which want the
// faster of both and cannot ask. What is seen is the same but for what gl_volume_renderer.h says.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/volume_gl/gl_volume_renderer.h"

namespace ocelli {

/// Where a volume may be drawn.
enum class VolumeDrawnBy {
  kGpuOrCpu,     ///< a software renderer of OpenGL is no GPU: the CPU's own renderer is faster
  kOpenGlOrCpu,  ///< also by a software renderer
};

/// Of one thread at a time. A GPU that fails, or whose memory is full, is given up for the CPU, silently: description()
/// says which of both draws.
class GpuOrCpuVolumeRenderer {
 public:
  /// Opens a context of its own, through EGL.
  explicit GpuOrCpuVolumeRenderer(VolumeScene scene, const VolumeRenderOptions& options = {},
                                  VolumeDrawnBy drawnBy = VolumeDrawnBy::kGpuOrCpu);
  ~GpuOrCpuVolumeRenderer();
  GpuOrCpuVolumeRenderer(const GpuOrCpuVolumeRenderer&) = delete;
  GpuOrCpuVolumeRenderer& operator=(const GpuOrCpuVolumeRenderer&) = delete;

  bool isOnGpu() const;
  /// "OpenGL on llvmpipe, through EGL", or "the CPU".
  std::string description() const;

  // As VolumeRenderer has them.
  const VolumeScene& scene() const;
  const VolumeRenderOptions& options() const;
  void setAppearance(const VolumeAppearance& appearance);
  void setClips(std::vector<ClipPlane> clips);
  void setOptions(const VolumeRenderOptions& options);
  VolumeImage render(int width, int height, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                     const Progress& progress = {});
  VolumeImage render(const PinholeCamera& camera, const Progress& progress = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
