#include "cli/gl_volume.h"

#include "cli/gl_drawing.h"
#include "oc_core/base/check.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/volume_gl/gl_volume_renderer.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_OPENGL

struct GlVolumeDrawing::Impl {
  std::unique_ptr<GlContext> context;
  std::unique_ptr<GlVolumeRenderer> renderer;
};

GlVolumeDrawing::GlVolumeDrawing(const std::string& provider) : impl_(std::make_unique<Impl>()) {
  impl_->context = openGlContext(provider, "--gl");
}

void GlVolumeDrawing::upload(const VolumeScene& scene, const VolumeRenderOptions& options, const Progress& progress) {
  impl_->renderer =
      std::make_unique<GlVolumeRenderer>(*impl_->context, scene, options, GlVolumeFilter::kExact, progress);
}

VolumeImage GlVolumeDrawing::render(const glm::ivec2& size,
                                    const std::function<RayPath(const glm::vec2& pixel)>& rayPath,
                                    const Progress& progress) const {
  OC_CHECK(impl_->renderer != nullptr, "a volume is uploaded before it is drawn");
  return impl_->renderer->render(size.x, size.y, rayPath, progress);
}

std::string GlVolumeDrawing::description() const {
  return describe(impl_->context->info());
}

#else

struct GlVolumeDrawing::Impl {};

GlVolumeDrawing::GlVolumeDrawing(const std::string& /*provider*/) {
  failWithoutOpenGl("--method");
}

void GlVolumeDrawing::upload(const VolumeScene& /*scene*/, const VolumeRenderOptions& /*options*/,
                             const Progress& /*progress*/) {
  failWithoutOpenGl("--method");
}

VolumeImage GlVolumeDrawing::render(const glm::ivec2& /*size*/,
                                    const std::function<RayPath(const glm::vec2& pixel)>& /*rayPath*/,
                                    const Progress& /*progress*/) const {
  failWithoutOpenGl("--method");
}

std::string GlVolumeDrawing::description() const {
  return {};
}

#endif

GlVolumeDrawing::~GlVolumeDrawing() = default;

}  // namespace ocelli
