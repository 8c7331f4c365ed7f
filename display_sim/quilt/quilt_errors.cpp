#include "display_sim/quilt/quilt_errors.h"

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

ViewFrame tileFrame(const QuiltViews& views, const QuiltPicture& quilt, int view) {
  OC_CHECK(!quilt.inverseZ.empty(), "the quilt keeps its depths");
  const PinholeCamera& camera = views.camera(view);
  const glm::ivec2 origin = views.tileOrigin(view);
  ViewFrame frame{Image<glm::vec4>(camera.width(), camera.height(), glm::vec4(0)),
                  Image<Rgb8>(camera.width(), camera.height())};
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      frame.image(x, y) = quilt.color(origin.x + x, origin.y + y);
      if (const float w = quilt.inverseZ(origin.x + x, origin.y + y); w > 0) {
        const ImagePoint q{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 1 / w};
        frame.points(x, y) = glm::vec4(camera.worldFromCamera(camera.cameraFromImage(q)), 1);
      }
    }
  }
  return frame;
}

std::vector<FrameErrors> quiltErrors(const QuiltViews& views, const Mesh& scene,
                                     const std::vector<const QuiltPicture*>& quilts, const Progress& progress) {
  std::vector<FrameErrors> sums(quilts.size());
  for (int view = 0; view < views.count(); ++view) {
    report(progress, "comparing views", static_cast<double>(view) / views.count());
    const ViewFrame truth = renderFrame(views.camera(view), scene);
    parallelFor(quilts.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const ViewFrame frame = tileFrame(views, *quilts[i], view);
        FrameErrors errors;
        errors.MissingSamples::operator+=(countMissing(compareFrames(views.camera(view), truth.points, frame.points)));
        addImageErrors(errors, truth, frame);
        sums[i] += errors;
      }
    });
  }
  return sums;
}

}  // namespace ocelli
