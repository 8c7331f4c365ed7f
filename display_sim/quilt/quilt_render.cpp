#include "display_sim/quilt/quilt_render.h"

#include "oc_core/base/parallel.h"
#include "oc_core/image/srgb_encoder.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {

QuiltPicture quiltByRender(const QuiltViews& views, const Mesh& scene, QuiltDepths depths, const Progress& progress) {
  QuiltPicture picture = blankQuilt(views.display(), depths);
  static const SrgbEncoder encoder;
  for (int view = 0; view < views.count(); ++view) {
    report(progress, "views", static_cast<double>(view) / views.count());
    const FragmentImage fragments = rasterize(views.camera(view), scene);
    const glm::ivec2 origin = views.tileOrigin(view);
    parallelFor(static_cast<size_t>(fragments.height()), 16, [&](size_t begin, size_t end) {
      for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
        for (int x = 0; x < fragments.width(); ++x) {
          const Fragment& fragment = fragments(x, y);
          if (!fragment.covered()) {
            continue;
          }
          picture.color(origin.x + x, origin.y + y) = encoder.bytesFromLinear(colorOf(fragment, scene));
          if (depths == QuiltDepths::kKept) {
            picture.inverseZ(origin.x + x, origin.y + y) = 1 / fragment.t;
          }
        }
      }
    });
  }
  return picture;
}

}  // namespace ocelli
