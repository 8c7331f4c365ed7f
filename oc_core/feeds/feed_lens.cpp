#include "oc_core/feeds/feed_lens.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace ocelli {
namespace {

constexpr int kMaxSteps = 40;
constexpr double kDirectionRounding = 1e-10;

glm::dvec2 distorted(const FeedLens& lens, const glm::dvec2& d) {
  const double r2 = glm::dot(d, d);
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  return d * radial + glm::dvec2(2 * lens.p1 * d.x * d.y + lens.p2 * (r2 + 2 * d.x * d.x),
                                 lens.p1 * (r2 + 2 * d.y * d.y) + 2 * lens.p2 * d.x * d.y);
}

/// Its derivatives: column by column, by x and by y.
glm::dmat2 slopes(const FeedLens& lens, const glm::dvec2& d) {
  const double r2 = glm::dot(d, d);
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double bySquare = lens.k1 + r2 * (2 * lens.k2 + 3 * r2 * lens.k3);
  const double mixed = 2 * d.x * d.y * bySquare + 2 * lens.p1 * d.x + 2 * lens.p2 * d.y;
  return {{radial + 2 * d.x * d.x * bySquare + 2 * lens.p1 * d.y + 6 * lens.p2 * d.x, mixed},
          {mixed, radial + 2 * d.y * d.y * bySquare + 6 * lens.p1 * d.y + 2 * lens.p2 * d.x}};
}

}  // namespace

std::optional<glm::dvec2> pixelOf(const FeedLens& lens, const glm::dvec2& direction) {
  if (!(glm::determinant(slopes(lens, direction)) > 0)) {
    return std::nullopt;
  }
  const glm::dvec2 pixel = lens.focal * distorted(lens, direction) + lens.center;
  return std::isfinite(pixel.x) && std::isfinite(pixel.y) ? std::optional(pixel) : std::nullopt;
}

std::optional<glm::dvec2> directionOf(const FeedLens& lens, const glm::dvec2& pixel) {
  const glm::dvec2 wanted = (pixel - lens.center) / lens.focal;
  glm::dvec2 direction = wanted;
  for (int step = 0; step < kMaxSteps; ++step) {
    const glm::dmat2 slope = slopes(lens, direction);
    if (!(glm::determinant(slope) > 0)) {
      return std::nullopt;
    }
    const glm::dvec2 change = glm::inverse(slope) * (wanted - distorted(lens, direction));
    direction += change;
    if (glm::length(change) < kDirectionRounding) {
      return direction;
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
