#include "display_sim/viewer/lens_painter.h"

#include "oc_core/focus/rate_image.h"
#include "oc_core/render/rasterize_gpc.h"

namespace ocelli {
namespace {

bool isSamePinhole(const PinholeCamera& a, const PinholeCamera& b) {
  return a.view() == b.view() && a.width() == b.width() && a.height() == b.height();
}

}  // namespace

RateRange rateRangeOf(const GpcLayout& layout) {
  RateRange range;
  for (const GpcRegion& region : layout.regions) {
    const GpcProfile profile(*layout.sampling, static_cast<double>(region.zoom), region.outer());
    range.least = std::min(range.least, profile.leastRate());
    range.greatest = std::max(range.greatest, profile.greatestRate());
  }
  return range;
}

FragmentImage LensPainter::drawn(const LensWanted& wanted, const GpcCamera& camera) {
  if (scene_ != wanted.scene) {
    projected_.reset();
    rays_.reset();
    scene_ = wanted.scene;
  }
  const Mesh& mesh = scene_->mesh;
  switch (wanted.method) {
    case LensesShown::Method::kRaster:
      if (!projected_ || !isSamePinhole(projected_->camera(), camera.reference())) {
        projected_.emplace(camera.reference(), mesh);
      }
      return rasterizeGpc(camera, *projected_);
    case LensesShown::Method::kRays:
      if (!rays_) {
        rays_ = std::make_unique<RayScene>(mesh);
      }
      return raycast(camera, mesh, *rays_);
  }
  OC_CHECK(false, "every method draws");
}

Image<Rgb8> LensPainter::paint(const LensWanted& wanted, const glm::ivec2& size, const Progress&) {
  const GpcCamera camera(PinholeCamera(wanted.view, size.x, size.y), wanted.layout);
  Image<Rgb8> picture = srgbFromLinear(colorImage(drawn(wanted, camera), wanted.scene->mesh, glm::vec3(0)));
  if (!wanted.rates) {
    return picture;
  }
  const Image<float> rates = rateImage(size, [&](const glm::dvec2& at) { return camera.map().rateAt(at); });
  return rateHeat(rates, rateRangeOf(wanted.layout), picture);
}

}  // namespace ocelli
