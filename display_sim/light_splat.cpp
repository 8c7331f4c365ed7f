#include "display_sim/light_splat.h"

#include <algorithm>

namespace ocelli {
namespace {

/// The pixels that [lo, hi] overlaps, of `count`.
struct PixelSpan {
  PixelSpan(double lo, double hi, int count)
      : first(static_cast<int>(std::clamp(lo, 0.0, static_cast<double>(count)))),
        end(hi <= 0 ? 0 : std::min(static_cast<int>(std::min(hi, static_cast<double>(count))) + 1, count)) {}
  int first;
  int end;
};

double overlap(double lo, double hi, int pixel) {
  return std::max(std::min(hi, pixel + 1.0) - std::max(lo, pixel + 0.0), 0.0);
}

}  // namespace

void LightImage::add(double u, double v, double boxWidth, double boxHeight, double light, const glm::dvec3& color) {
  const double left = u - boxWidth / 2;
  const double right = u + boxWidth / 2;
  const double top = v - boxHeight / 2;
  const double bottom = v + boxHeight / 2;
  const PixelSpan columns(left, right, width_);
  const PixelSpan rows(top, bottom, height_);
  const double density = light * kLightUnit / (boxWidth * boxHeight);
  for (int row = rows.first; row < rows.end; ++row) {
    const double rowDensity = density * overlap(top, bottom, row);
    FixedLight* pixels = pixels_.data() + static_cast<size_t>(row) * static_cast<size_t>(width_);
    for (int column = columns.first; column < columns.end; ++column) {
      const glm::dvec3 share = color * (rowDensity * overlap(left, right, column)) + 0.5;
      FixedLight& pixel = pixels[column];
      pixel[0] += static_cast<uint64_t>(share.x);
      pixel[1] += static_cast<uint64_t>(share.y);
      pixel[2] += static_cast<uint64_t>(share.z);
    }
  }
}

}  // namespace ocelli
