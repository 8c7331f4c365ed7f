#include "display_sim/viewer/lens_painter.h"

#include "oc_core/render/rasterize_gpc.h"

namespace ocelli {
namespace {

bool isSamePinhole(const PinholeCamera& a, const PinholeCamera& b) {
  return a.view() == b.view() && a.width() == b.width() && a.height() == b.height();
}

Image<float> ratesOf(const GpcMap& map, int width, int height) {
  Image<float> rates(width, height);
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        const int row = static_cast<int>(y);
        rates(x, row) = static_cast<float>(map.rateAt(glm::dvec2(x, row) + 0.5));
      }
    }
  });
  return rates;
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

Image<Rgb8> LensPainter::paint(const LensWanted& wanted, const glm::ivec2& size) {
  const GpcCamera camera(PinholeCamera(wanted.view, size.x, size.y), wanted.layout);
  Image<Rgb8> picture = srgbFromLinear(colorImage(drawn(wanted, camera), wanted.scene->mesh, glm::vec3(0)));
  return wanted.rates ? rateHeat(ratesOf(camera.map(), size.x, size.y), rateRangeOf(wanted.layout), picture) : picture;
}

}  // namespace ocelli
