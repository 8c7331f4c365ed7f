#include "cli/gl_display.h"

#include "cli/gl_drawing.h"
#ifdef OCELLI_WITH_OPENGL
#include "display_sim/gl/gl_observer.h"
#include "display_sim/gl/gl_slicer.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_OPENGL

Volume sliceWithGl(const std::string& provider, const Mesh& mesh, const DisplayProfile& profile,
                   const SliceOptions& options) {
  const auto context = openGlContext(provider, "--gl");
  const GlScope scope(*context);
  GlVolume volume(*context, profile);
  GlSlicer(*context).slice(GlMesh(*context, mesh), volume, options);
  return volume.read();
}

Image<glm::vec3> collectLightWithGl(const std::string& provider, const Volume& volume, const ObserverOptions& options) {
  const auto context = openGlContext(provider, "--gl");
  const GlScope scope(*context);
  const GlVolume onGpu(*context, volume);
  GlObserver observer(*context);
  observer.look(onGpu);
  observer.draw({options});
  return observer.readLight();
}

#else

Volume sliceWithGl(const std::string& /*provider*/, const Mesh& /*mesh*/, const DisplayProfile& /*profile*/,
                   const SliceOptions& /*options*/) {
  failWithoutOpenGl();
}

Image<glm::vec3> collectLightWithGl(const std::string& /*provider*/, const Volume& /*volume*/,
                                    const ObserverOptions& /*options*/) {
  failWithoutOpenGl();
}

#endif

}  // namespace ocelli
