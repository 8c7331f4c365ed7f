#include "oc_core/camera/ddoc_camera.h"

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {

DdocCamera::DdocCamera(const PinholeCamera& reference, DistortionMap map)
    : reference_(reference),
      map_(std::move(map)),
      longestDisplacement_(map_.longestDisplacement()),
      bounds_(std::make_shared<LazyBounds>()),
      displacedBefore_(reference.width() + 1, reference.height() + 1, 0) {
  OC_CHECK(map_.samples().width() == reference.width() && map_.samples().height() == reference.height(),
           "a distortion map has one sample for each pixel of its reference camera");
  // Within each row, then each row on top of the one above.
  parallelFor(static_cast<size_t>(height()), 32, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      uint32_t inRow = 0;
      for (int x = 0; x < width(); ++x) {
        inRow += map_.samples()(x, y).displacement != glm::vec2(0);
        displacedBefore_(x + 1, y + 1) = inRow;
      }
    }
  });
  for (int y = 0; y < height(); ++y) {
    const uint32_t* above = &displacedBefore_(0, y);
    uint32_t* counts = &displacedBefore_(0, y + 1);
    for (int x = 0; x <= width(); ++x) {
      counts[x] += above[x];
    }
  }
}

std::optional<ImagePoint> DdocCamera::undistort(const ImagePoint& q, const glm::vec2& guess) const {
  // Fixed point of x = q - displacement(x, z), damped. It converges where the field contracts (its slope is below 1).
  constexpr int kMaxSteps = 60;
  constexpr float kTolerancePixels = 1e-3f;
  const glm::vec2 target(q.u, q.v);
  glm::vec2 x = guess;
  float damping = 1;
  float lastError = 1e30f;
  for (int step = 0; step < kMaxSteps; ++step) {
    const ImagePoint image = distort({x.x, x.y, q.t});
    const glm::vec2 residual = target - glm::vec2(image.u, image.v);
    const float error = glm::length(residual);
    if (error < kTolerancePixels) {
      return ImagePoint{x.x, x.y, q.t};
    }
    damping = error > lastError ? std::max(damping * 0.5f, 0.1f) : damping;
    lastError = error;
    x += residual * damping;
  }
  return std::nullopt;
}

std::optional<glm::vec3> DdocCamera::unproject(const ImagePoint& q) const {
  if (!reference_.unproject(q)) {  // not finite, or out of the depth range
    return std::nullopt;
  }
  const std::optional<ImagePoint> undistorted = undistort(q, {q.u, q.v});
  return undistorted ? reference_.unproject(*undistorted) : std::nullopt;
}

RayPath DdocCamera::rayPath(const glm::vec2& pixel) const {
  RayPath path = reference_.rayPath(pixel);
  if (path.empty()) {
    return path;
  }
  // The displacement that brings a point to this pixel is the longest one at most, so it is one of those within that
  // distance, which may be shorter, and so on.
  float reach = longestDisplacement_;
  DisplacementBounds::Range around;
  for (int round = 0; round < 4 && reach > 0; ++round) {
    around = bounds().over({pixel - reach, pixel + reach});
    if (around.longest() >= reach) {
      break;
    }
    reach = around.longest();
  }
  if (around.rampUpper <= 0 || reach <= 0) {
    return path;
  }
  // Straight up to the nearest z_n and beyond the farthest z_f of those; in between, equal steps of 1/z, each solved
  // from the solution before it, about a quarter of a pixel apart. A step without a solution is left out: the ray goes
  // straight over it, or ends before it where none follows. The search for a solution starts where the last two point.
  constexpr float kStepsPerPixel = 4;
  constexpr float kMaxSteps = 96;
  const int steps = static_cast<int>(std::clamp(reach * kStepsPerPixel, 4.0f, kMaxSteps));
  RayPath bent;
  bent.add(path.front(), path.tMin());
  glm::vec2 undistorted = pixel;
  glm::vec2 advance(0);
  const auto addPointAt = [&](float z) {
    if (const std::optional<ImagePoint> solved = undistort({pixel.x, pixel.y, z}, undistorted + advance)) {
      if (const std::optional<glm::vec3> point = reference_.unproject(*solved)) {
        advance = glm::vec2(solved->u, solved->v) - undistorted;
        undistorted = {solved->u, solved->v};
        bent.add(*point, z);
      }
    }
  };
  for (int i = 0; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    addPointAt(1 / (around.rampUpper + (around.rampLower - around.rampUpper) * share));
  }
  advance = glm::vec2(0);
  addPointAt(reference_.view().zFar);
  return bent;
}

}  // namespace ocelli
