// `--method gl` of the commands that draw volumes.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/camera/camera.h"
#include "oc_core/volume_render/volume_renderer.h"

namespace ocelli {

class GlVolumeDrawing {
 public:
  /// Opens the context: before the volume is loaded, so that a machine without OpenGL says so at once. Throws
  /// InputError where this program was built without OpenGL, GlError where no context can be opened.
  explicit GlVolumeDrawing(const std::string& provider);
  ~GlVolumeDrawing();
  GlVolumeDrawing(const GlVolumeDrawing&) = delete;
  GlVolumeDrawing& operator=(const GlVolumeDrawing&) = delete;

  /// Uploads the volume. Throws GlError where the GPU has no room for it.
  void upload(const VolumeScene& scene, const VolumeRenderOptions& options, const Progress& progress);
  /// What the rays of an image see of the volume that was uploaded.
  VolumeImage render(const glm::ivec2& size, const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                     const Progress& progress) const;
  /// "OpenGL on llvmpipe, through EGL".
  std::string description() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ocelli
