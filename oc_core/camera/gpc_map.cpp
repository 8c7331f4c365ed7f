#include "oc_core/camera/gpc_map.h"

#include <cmath>
#include <utility>

namespace ocelli {

GpcZone::GpcZone(const GpcRegion& region, const GpcSampling& sampling, const glm::ivec2& size)
    : center_(glm::dvec2(region.center) * glm::dvec2(size)),
      half_(glm::dvec2(region.extent) * glm::dvec2(size) / 2.0),
      profile_(sampling, static_cast<double>(region.zoom), region.outer()) {}

glm::dmat2 GpcZone::jacobian(const glm::dvec2& image) const {
  const glm::dvec2 d = image - center_;
  const double r = distance(image);
  if (r <= 1 || r >= profile_.outer()) {
    return glm::dmat2(r <= 1 ? 1 / profile_.zoom() : 1.0);
  }
  // p = c + g(r) d with g = f / r: dp = g I + d (g' dr), and r g' = f' - g. r depends on one coordinate alone.
  const double g = profile_.sampled(r) / r;
  const double along = (profile_.slope(r) - g) / r;
  const bool isBeside = std::abs(d.x) / half_.x >= std::abs(d.y) / half_.y;
  const int axis = isBeside ? 0 : 1;
  glm::dmat2 result(g);
  result[axis] += d * (along * std::copysign(1 / half_[axis], d[axis]));
  return result;
}

glm::dvec2 GpcZone::magnificationOver(const ImageBox& pinhole) const {
  const glm::dvec2 lower = glm::dvec2(pinhole.lower) - center_;
  const glm::dvec2 upper = glm::dvec2(pinhole.upper) - center_;
  // Of the nearest and the farthest point of the box from the centre.
  const glm::dvec2 nearest = glm::max(glm::max(lower, -upper), 0.0) / half_;
  const glm::dvec2 farthest = glm::max(glm::abs(lower), glm::abs(upper)) / half_;
  const double first = magnification(std::max(nearest.x, nearest.y));
  const double last = magnification(std::max(farthest.x, farthest.y));
  constexpr double kRounding = 1e-12;
  return {std::min(first, last) * (1 - kRounding), std::max(first, last) * (1 + kRounding)};
}

ImageBox GpcZone::imageBox(const ImageBox& pinhole) const {
  const glm::dvec2 factors = magnificationOver(pinhole);
  const glm::dvec2 lower = glm::dvec2(pinhole.lower) - center_;
  const glm::dvec2 upper = glm::dvec2(pinhole.upper) - center_;
  const glm::dvec2 a = center_ + glm::min(lower * factors.x, lower * factors.y);
  const glm::dvec2 b = center_ + glm::max(upper * factors.x, upper * factors.y);
  constexpr float kSingle = 1e-6f;  // of rounding to single precision
  const glm::vec2 slack = glm::max(glm::abs(glm::vec2(a)), glm::abs(glm::vec2(b))) * kSingle;
  return {glm::vec2(a) - slack, glm::vec2(b) + slack};
}

GpcMap::GpcMap(GpcLayout layout, int width, int height) : layout_(std::move(layout)) {
  validate(layout_, "general pinhole camera");
  for (const GpcRegion& region : layout_.regions) {
    zones_.emplace_back(region, *layout_.sampling, glm::ivec2(width, height));
  }
}

glm::dmat2 GpcMap::jacobian(const glm::dvec2& image) const {
  const GpcZone* zone = zoneAt(image);
  return zone != nullptr ? zone->jacobian(image) : glm::dmat2(1.0);
}

double GpcMap::rateAt(const glm::dvec2& image) const {
  return 1 / singularValues(jacobian(image)).x;
}

glm::dvec2 singularValues(const glm::dmat2& m) {
  // Of a matrix [a c; b d]: half the sum and half the difference of the squared singular values.
  const double a = m[0].x;
  const double b = m[0].y;
  const double c = m[1].x;
  const double d = m[1].y;
  const double sum = std::hypot(a + d, b - c);
  const double difference = std::hypot(a - d, b + c);
  return {(sum + difference) / 2, std::abs(sum - difference) / 2};
}

}  // namespace ocelli
