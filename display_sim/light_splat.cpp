#include "display_sim/light_splat.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"

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

/// Of the unit disc's area, what lies above the height y, which counts downwards.
double shareAbove(double y) {
  y = std::clamp(y, -1.0, 1.0);
  return 0.5 + (std::asin(y) + y * std::sqrt(1 - y * y)) / kPi;
}

}  // namespace

void LightImage::addSpan(int row, double left, double right, double light, const glm::dvec3& color) {
  const PixelSpan columns(left, right, width_);
  const double density = light * kLightUnit / (right - left);
  FixedLight* pixels = pixels_.data() + static_cast<size_t>(row) * static_cast<size_t>(width_);
  for (int column = columns.first; column < columns.end; ++column) {
    const glm::dvec3 share = color * (density * overlap(left, right, column)) + 0.5;
    FixedLight& pixel = pixels[column];
    pixel[0] += static_cast<uint64_t>(share.x);
    pixel[1] += static_cast<uint64_t>(share.y);
    pixel[2] += static_cast<uint64_t>(share.z);
  }
}

void LightImage::addBox(double u, double v, double boxWidth, double boxHeight, double light, const glm::dvec3& color) {
  const double top = v - boxHeight / 2;
  const double bottom = v + boxHeight / 2;
  const PixelSpan rows(top, bottom, height_);
  for (int row = rows.first; row < rows.end; ++row) {
    addSpan(row, u - boxWidth / 2, u + boxWidth / 2, light / boxHeight * overlap(top, bottom, row), color);
  }
}

void LightImage::addEllipse(double u, double v, double ellipseWidth, double ellipseHeight, double light,
                            const glm::dvec3& color) {
  const PixelSpan rows(v - ellipseHeight / 2, v + ellipseHeight / 2, height_);
  double y = std::max(rows.first - v, -ellipseHeight / 2);
  double above = shareAbove(2 * y / ellipseHeight);
  for (int row = rows.first; row < rows.end; ++row) {
    const double nextY = std::min(row + 1 - v, ellipseHeight / 2);
    const double nextAbove = shareAbove(2 * nextY / ellipseHeight);
    const double share = nextAbove - above;
    if (share > 0) {
      const double width = share * kPi / 4 * ellipseWidth * ellipseHeight / (nextY - y);
      addSpan(row, u - width / 2, u + width / 2, light * share, color);
    }
    y = nextY;
    above = nextAbove;
  }
}

}  // namespace ocelli
