#include "display_sim/viewer/volume_painter.h"

#include "oc_core/volume_camera/volume_camera.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_render/volume_target.h"

namespace ocelli {
void VolumePainter::prepare(const VolumeWanted& wanted, bool isPreview) {
  if (volume_ != wanted.scene->volume) {
    volume_ = nullptr;  // until the next line, which may throw, has prepared one
    renderer_.emplace(wanted.scene->volume->scene);
    volume_ = wanted.scene->volume;
    appearance_ = nullptr;
    kept_ = {};
  }
  if (appearance_ != wanted.appearance) {
    renderer_->setAppearance(*wanted.appearance);
    appearance_ = wanted.appearance;
  }
  if (kept_ != wanted.kept) {
    renderer_->setClips(clipsOf(volume_->scene, wanted.kept));
    kept_ = wanted.kept;
  }
  VolumeRenderOptions options;
  options.step *= isPreview ? kPreviewStep : 1;
  if (renderer_->options().step != options.step) {
    renderer_->setOptions(options);
  }
}

Image<Rgb8> VolumePainter::paint(const VolumeWanted& wanted, const glm::ivec2& size, const Progress& progress) {
  prepare(wanted, size != wanted.size);
  std::optional<VolumeTarget> target;
  const auto firstHits = [&]() -> const RayTarget& { return target.emplace(*renderer_); };
  const PinholeCamera reference(wanted.view, size.x, size.y);
  const VolumeCamera camera = wanted.rays.empty()
                                  ? volumeCamera(wanted.camera, reference, firstHits, progress)
                                  : volumeCamera(wanted.rays, reference, renderer_->scene(), firstHits, progress);
  const VolumeImage pixels =
      renderer_->render(camera.size.x, camera.size.y, camera.ray, progress, camera.hull, camera.isSmooth);
  return srgbFromLinear(imageBefore(glm::vec3(0), pixels));
}

}  // namespace ocelli
