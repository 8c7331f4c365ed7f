#include "oc_core/volume_gl/gpu_or_cpu_volume_renderer.h"

#include <optional>
#include <utility>

namespace ocelli {
namespace {

/// Null where there is none, or none that is wanted.
std::unique_ptr<GlContext> openGpu(VolumeDrawnBy drawnBy) {
  try {
    std::unique_ptr<GlContext> context = openGlContext(GlProvider::kEgl);
    return context->info().isSoftware && drawnBy == VolumeDrawnBy::kGpuOrCpu ? nullptr : std::move(context);
  } catch (const GlError&) {  // nothing that draws
    return nullptr;
  }
}

}  // namespace

struct GpuOrCpuVolumeRenderer::Impl {
  VolumeScene scene;
  VolumeRenderOptions options;
  std::unique_ptr<GlContext> context;       ///< goes after what draws with it
  std::unique_ptr<GlVolumeRenderer> onGpu;  ///< null: on the CPU
  std::optional<VolumeRenderer> onCpu;

  /// `onGpuDo` with the GPU's renderer, or where there is none, or it fails, `onCpuDo` with the CPU's.
  template <class OnGpu, class OnCpu>
  auto tryOnGpu(const OnGpu& onGpuDo, const OnCpu& onCpuDo) {
    if (onGpu) {
      try {
        return onGpuDo(*onGpu);
      } catch (const GlError&) {
        giveGpuUp();
      }
    }
    return onCpuDo(*onCpu);
  }
  void giveGpuUp() {
    onGpu.reset();
    context.reset();
    onCpu.emplace(scene, options);
  }
};

GpuOrCpuVolumeRenderer::GpuOrCpuVolumeRenderer(VolumeScene scene, const VolumeRenderOptions& options,
                                               VolumeDrawnBy drawnBy)
    : impl_(std::make_unique<Impl>(Impl{std::move(scene), options, openGpu(drawnBy), nullptr, std::nullopt})) {
  try {
    if (impl_->context) {
      impl_->onGpu = std::make_unique<GlVolumeRenderer>(*impl_->context, impl_->scene, options);
    }
  } catch (const GlError&) {  // too large for it
  }
  if (!impl_->onGpu) {
    impl_->giveGpuUp();
  }
}

GpuOrCpuVolumeRenderer::~GpuOrCpuVolumeRenderer() = default;

bool GpuOrCpuVolumeRenderer::isOnGpu() const {
  return impl_->onGpu != nullptr;
}
std::string GpuOrCpuVolumeRenderer::description() const {
  return impl_->onGpu ? describe(impl_->context->info()) : "the CPU";
}
const VolumeScene& GpuOrCpuVolumeRenderer::scene() const {
  return impl_->scene;
}
const VolumeRenderOptions& GpuOrCpuVolumeRenderer::options() const {
  return impl_->options;
}

void GpuOrCpuVolumeRenderer::setAppearance(const VolumeAppearance& appearance) {
  impl_->scene.appearance = appearance;
  const auto set = [&](auto& renderer) { renderer.setAppearance(appearance); };
  impl_->tryOnGpu(set, set);
}
void GpuOrCpuVolumeRenderer::setClips(std::vector<ClipPlane> clips) {
  impl_->scene.clips = std::move(clips);
  const auto set = [&](auto& renderer) { renderer.setClips(impl_->scene.clips); };
  impl_->tryOnGpu(set, set);
}
void GpuOrCpuVolumeRenderer::setOptions(const VolumeRenderOptions& options) {
  impl_->options = options;
  const auto set = [&](auto& renderer) { renderer.setOptions(options); };
  impl_->tryOnGpu(set, set);
}

VolumeImage GpuOrCpuVolumeRenderer::render(int width, int height,
                                           const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                                           const Progress& progress) {
  const auto draw = [&](auto& renderer) { return renderer.render(width, height, rayPath, progress); };
  return impl_->tryOnGpu(draw, draw);
}

VolumeImage GpuOrCpuVolumeRenderer::render(const PinholeCamera& camera, const Progress& progress) {
  return impl_->tryOnGpu([&](GlVolumeRenderer& renderer) { return renderer.render(camera, progress); },
                         [&](VolumeRenderer& renderer) { return renderVolume(camera, renderer, progress); });
}

}  // namespace ocelli
