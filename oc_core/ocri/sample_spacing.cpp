#include "oc_core/ocri/sample_spacing.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/gpc_map.h"

namespace ocelli {

Image<float> sampleSpacings(const ReferenceImage& image) {
  if (image.tileSide > 0) {
    Image<float> spacings(image.width(), image.height(), 1);
    std::fill(
        spacings.begin() + static_cast<std::ptrdiff_t>(std::min(image.pinholeSize.y, image.height())) * image.width(),
        spacings.end(), image.tileSpacing);
    return spacings;
  }
  if (image.layout.regions.empty()) {
    return {};
  }
  const GpcMap map(image.layout, image.width(), image.height());
  Image<float> spacings(image.width(), image.height());
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width(); ++x) {
        spacings(x, y) = static_cast<float>(std::sqrt(glm::determinant(map.jacobian(glm::dvec2(x, y) + 0.5))));
      }
    }
  });
  return spacings;
}

}  // namespace ocelli
