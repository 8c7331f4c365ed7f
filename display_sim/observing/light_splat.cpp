#include "display_sim/observing/light_splat.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

/// More images than this cost more to add up than their threads save.
constexpr size_t kMaxImages = 16;
constexpr size_t kMaxImageBytes = size_t{1} << 30;

/// A pixel's share of one box that is larger than this is cut off: numbers of 64 bits hold it.
constexpr double kMaxShare = 0x1p62;

/// The pixels that [lo, hi] overlaps, of `count`; none where one of them is NaN.
struct PixelSpan {
  PixelSpan(double lo, double hi, int count) {
    if (lo < hi && hi > 0 && lo < count) {
      first = static_cast<int>(std::max(lo, 0.0));
      end = static_cast<int>(std::min(hi, count - 1.0)) + 1;
    }
  }
  int first = 0;
  int end = 0;
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

size_t lightImageCount(int width, int height, int threads) {
  const size_t bytes = static_cast<size_t>(width) * static_cast<size_t>(height) * sizeof(FixedLight);
  const size_t most = std::clamp<size_t>(kMaxImageBytes / bytes, 1, kMaxImages);
  return std::clamp<size_t>(static_cast<size_t>(std::max(threads, 1)), 1, most);
}

void LightImage::addSpan(int row, double left, double right, double light, const glm::dvec3& color) {
  const PixelSpan columns(left, right, width_);
  const double density = light * kLightUnit / (right - left);
  FixedLight* pixels = pixels_.data() + static_cast<size_t>(row) * static_cast<size_t>(width_);
  for (int column = columns.first; column < columns.end; ++column) {
    const glm::dvec3 share = glm::min(color * (density * overlap(left, right, column)) + 0.5, kMaxShare);
    addLight(pixels[column],
             {static_cast<uint64_t>(share.x), static_cast<uint64_t>(share.y), static_cast<uint64_t>(share.z)});
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
