#include "oc_core/camera/ddoc_camera.h"

#include <glm/geometric.hpp>

namespace ocelli {

DdocCamera::DdocCamera(const PinholeCamera& reference, DistortionMap map)
    : reference_(reference), map_(std::move(map)), displacedBefore_(reference.width() + 1, reference.height() + 1, 0) {
  OC_CHECK(map_.samples().width() == reference.width() && map_.samples().height() == reference.height(),
           "a distortion map has one sample for each pixel of its reference camera");
  leastInverseFar_ = 1 / reference.view().zNear;
  float longestSquared = 0;
  for (int y = 0; y < height(); ++y) {
    uint32_t inRow = 0;
    for (int x = 0; x < width(); ++x) {
      const DistortionSample& sample = map_.samples()(x, y);
      if (sample.displacement != glm::vec2(0)) {
        ++inRow;
        longestSquared = std::max(longestSquared, glm::dot(sample.displacement, sample.displacement));
        greatestInverseNear_ = std::max(greatestInverseNear_, sample.inverseNear);
        leastInverseFar_ = std::min(leastInverseFar_, sample.inverseFar);
      }
      displacedBefore_(x + 1, y + 1) = displacedBefore_(x + 1, y) + inRow;
    }
  }
  longestDisplacement_ = std::sqrt(longestSquared);
}

std::optional<ImagePoint> DdocCamera::undistort(const ImagePoint& q, const glm::vec2& guess) const {
  // Fixed point of x = q - displacement(x, z), damped. It converges where the field contracts (its slope is below 1).
  constexpr int kMostSteps = 60;
  constexpr float kTolerancePixels = 1e-3f;
  const glm::vec2 target(q.u, q.v);
  glm::vec2 x = guess;
  float damping = 1;
  float lastError = 1e30f;
  for (int step = 0; step < kMostSteps; ++step) {
    const ImagePoint image = distort({x.x, x.y, q.z});
    const glm::vec2 residual = target - glm::vec2(image.u, image.v);
    const float error = glm::length(residual);
    if (error < kTolerancePixels) {
      return ImagePoint{x.x, x.y, q.z};
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
  if (path.empty() || greatestInverseNear_ <= 0) {
    return path;
  }
  // Straight up to the nearest z_n and beyond the farthest z_f of the map; in between, equal steps of 1/z, each solved
  // from the solution before it. A step without a solution is left out: the ray goes straight over it, or ends before
  // it where none follows.
  constexpr int kSteps = 96;
  RayPath bent{path.front()};
  glm::vec2 undistorted = pixel;
  const auto addPointAt = [&](float z) {
    if (const std::optional<ImagePoint> solved = undistort({pixel.x, pixel.y, z}, undistorted)) {
      if (const std::optional<glm::vec3> point = reference_.unproject(*solved)) {
        undistorted = {solved->u, solved->v};
        bent.push_back(*point);
      }
    }
  };
  for (int i = 0; i <= kSteps; ++i) {
    addPointAt(1 / (greatestInverseNear_ + (leastInverseFar_ - greatestInverseNear_) * static_cast<float>(i) / kSteps));
  }
  addPointAt(reference_.view().zFar);
  return bent;
}

}  // namespace ocelli
