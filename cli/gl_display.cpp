#include "cli/gl_display.h"

#include "cli/gl_drawing.h"
#ifdef OCELLI_WITH_OPENGL
#include "display_sim/gl/gl_observer.h"
#include "display_sim/gl/gl_slicer.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_OPENGL

struct GlDisplay::Impl {
  std::unique_ptr<GlContext> context;
};

GlDisplay::GlDisplay(const std::string& provider) : impl_(std::make_unique<Impl>()) {
  impl_->context = openGlContext(provider, "--gl");
}

Volume GlDisplay::slice(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options) {
  GlContext& context = *impl_->context;
  const GlScope scope(context);
  GlVolume volume(context, profile);
  GlSlicer(context).slice(GlMesh(context, mesh), volume, options);
  return volume.read();
}

CollectLight GlDisplay::observerOf(const Volume& volume) {
  struct Watched {
    Watched(GlContext& context, const Volume& volume) : onGpu(context, volume), observer(context) {
      observer.look(onGpu);
    }
    GlVolume onGpu;
    GlObserver observer;
  };
  GlContext& context = *impl_->context;
  const GlScope scope(context);
  const auto watched = std::make_shared<Watched>(context, volume);
  return [watched](const ObserverOptions& options) {
    watched->observer.draw({options});
    return watched->observer.readLight();
  };
}

std::string GlDisplay::description() const {
  return describe(impl_->context->info());
}

#else

struct GlDisplay::Impl {};

GlDisplay::GlDisplay(const std::string& /*provider*/) {
  failWithoutOpenGl();
}

Volume GlDisplay::slice(const Mesh& /*mesh*/, const DisplayProfile& /*profile*/, const SliceOptions& /*options*/) {
  failWithoutOpenGl();
}

CollectLight GlDisplay::observerOf(const Volume& /*volume*/) {
  failWithoutOpenGl();
}

std::string GlDisplay::description() const {
  return {};
}

#endif

GlDisplay::~GlDisplay() = default;

}  // namespace ocelli
