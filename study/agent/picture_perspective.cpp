#include "study/agent/picture_perspective.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr size_t kMinPoints = 4;
/// Longest to shortest axis of the map.
constexpr double kMaxFlatness = 50;
/// Of the spread of the points, for directions in which they do not spread at all: heights of a floor.
constexpr double kRidgeShare = 1e-6;
/// Points that spread less than that across the floor, as a share of their spread along it, lie in a line.
constexpr double kLineShare = 1e-3;

/// A symmetric matrix as its eigenvalues, the larger first, and the direction of the first.
struct Axes {
  double large = 0;
  double small = 0;
  glm::dvec2 direction{1, 0};
};

Axes axesOf(const glm::dmat2& symmetric) {
  const double a = symmetric[0][0];
  const double b = symmetric[1][0];
  const double c = symmetric[1][1];
  const double middle = (a + c) / 2;
  const double half = std::hypot((a - c) / 2, b);
  const double angle = std::atan2(2 * b, a - c) / 2;
  return {middle + half, middle - half, {std::cos(angle), std::sin(angle)}};
}

/// Raises the shorter of the axes of a map.
glm::dmat2 notTooFlat(const glm::dmat2& map) {
  // The axes are those of mapᵀ map, in metres.
  const Axes axes = axesOf(glm::transpose(map) * map);
  const double longest = std::sqrt(std::max(axes.large, 0.0));
  const double shortest = std::sqrt(std::max(axes.small, 0.0));
  if (shortest * kMaxFlatness >= longest) {
    return map;
  }
  const glm::dvec2 across(-axes.direction.y, axes.direction.x);
  // Where it has no direction of its own, that which keeps the picture unmirrored.
  const glm::dvec2 along = map * axes.direction / longest;
  const glm::dvec2 shown = shortest > 0 ? map * across / shortest : glm::dvec2(-along.y, along.x);
  return map + glm::outerProduct(shown * (longest / kMaxFlatness - shortest), across);
}

}  // namespace

double PicturePerspective::pixelsPerMeter() const {
  return std::sqrt(std::abs(glm::determinant(pixelsFromMeters)));
}

double PicturePerspective::turnRadians() const {
  // The rotation nearest to the map (its polar decomposition).
  const glm::dmat2& m = pixelsFromMeters;
  return std::atan2(m[0][1] - m[1][0], m[0][0] + m[1][1]);
}

glm::dvec2 PicturePerspective::metersFrom(const glm::dvec2& pixels) const {
  return glm::inverse(pixelsFromMeters) * pixels;
}

glm::dmat2 PicturePerspective::placeCovariance(double pixels) const {
  const glm::dmat2 inverse = glm::inverse(pixelsFromMeters);
  return pixels * pixels * (inverse * glm::transpose(inverse));
}

double turnBetween(const PicturePerspective& a, const PicturePerspective& b) {
  return std::abs(std::remainder(a.turnRadians() - b.turnRadians(), 2 * kPi));
}

void PerspectiveFit::add(const glm::dvec2& pixel, const glm::dvec3& point) {
  pixels_.push_back(pixel);
  points_.push_back(point);
}

std::optional<PicturePerspective> PerspectiveFit::result() const {
  if (points_.size() < kMinPoints) {
    return std::nullopt;
  }
  const auto count = static_cast<double>(points_.size());
  glm::dvec2 middlePixel(0);
  glm::dvec3 middlePoint(0);
  for (size_t i = 0; i < points_.size(); ++i) {
    middlePixel += pixels_[i] / count;
    middlePoint += points_[i] / count;
  }
  glm::dmat3 spread(0);
  glm::dmat3x2 together(0);
  for (size_t i = 0; i < points_.size(); ++i) {
    const glm::dvec3 point = points_[i] - middlePoint;
    spread += glm::outerProduct(point, point);
    together += glm::outerProduct(pixels_[i] - middlePixel, point);
  }
  const Axes floor = axesOf({{spread[0][0], spread[0][2]}, {spread[2][0], spread[2][2]}});
  if (floor.large <= 0 || floor.small <= kLineShare * kLineShare * floor.large) {
    return std::nullopt;
  }
  const double ridge = kRidgeShare * (spread[0][0] + spread[1][1] + spread[2][2]);
  const glm::dmat3x2 map = together * glm::inverse(spread + glm::dmat3(ridge));
  const glm::dmat2 ofFloor = notTooFlat({map[0], map[2]});
  if (!(std::abs(glm::determinant(ofFloor)) > 0)) {
    return std::nullopt;  // all of it in one pixel
  }
  return PicturePerspective{ofFloor};
}

}  // namespace ocelli
