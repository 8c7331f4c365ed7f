#include "oc_core/camera/ddoc_camera.h"

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Little more than rounding, 700 pixels from the corner of an image.
constexpr float kExactPixels = 1e-4f;

}  // namespace

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
  const std::optional<ImagePoint> direct = undistortDirectly(q, guess);
  return direct ? direct : searchUndistorted(q, guess);
}

std::optional<ImagePoint> DdocCamera::undistortDirectly(const ImagePoint& q, const glm::vec2& guess) const {
  // Newton's method: exact where displacement and ramp are linear, so a step or two within a cell, one more for each
  // border that is crossed. Nothing where it strays: the field folds there, or tears.
  constexpr int kMaxSteps = 8;
  constexpr float kTolerancePixels = 1e-5f;  // less than rounding in most images
  constexpr float kLongestStep = 4;
  const float w = 1 / q.t;
  const glm::vec2 target(q.u, q.v);
  glm::vec2 x = guess;
  glm::vec2 last = guess;
  float lastError = 1e30f;
  for (int step = 0; step < kMaxSteps; ++step) {
    const DistortionMap::Sloped at = map_.slopedAt(x.x, x.y);
    const float range = at.value.inverseNear - at.value.inverseFar;
    const float ramp = range > 0 ? std::clamp((at.value.inverseNear - w) / range, 0.0f, 1.0f) : 0.0f;
    const glm::vec2 residual = target - (x + at.value.displacement * ramp);
    const float error = glm::length(residual);
    if (error < kTolerancePixels) {
      return ImagePoint{x.x, x.y, q.t};
    }
    if (!(error < lastError)) {  // as near as rounding lets it come, or astray
      return lastError < kExactPixels ? std::optional(ImagePoint{last.x, last.y, q.t}) : std::nullopt;
    }
    last = x;
    lastError = error;
    // How the displaced point changes with x.
    const auto slope = [&](const DistortionSample& along) {
      const bool ramps = ramp > 0 && ramp < 1;
      const float rampSlope =
          ramps ? (along.inverseNear - ramp * (along.inverseNear - along.inverseFar)) / range : 0.0f;
      return along.displacement * ramp + at.value.displacement * rampSlope;
    };
    const glm::vec2 alongU = glm::vec2(1, 0) + slope(at.alongU);
    const glm::vec2 alongV = glm::vec2(0, 1) + slope(at.alongV);
    const float determinant = alongU.x * alongV.y - alongV.x * alongU.y;
    const glm::vec2 advance =
        glm::vec2(alongV.y * residual.x - alongV.x * residual.y, alongU.x * residual.y - alongU.y * residual.x) /
        determinant;
    if (!(determinant > 0) || !(glm::length(advance) <= kLongestStep)) {
      return std::nullopt;
    }
    x += advance;
  }
  return std::nullopt;
}

std::optional<ImagePoint> DdocCamera::searchUndistorted(const ImagePoint& q, const glm::vec2& guess) const {
  // Fixed point of x = q - displacement(x, z), damped. It converges where the field contracts (its slope is below 1).
  constexpr int kMaxSteps = 60;
  constexpr float kAcceptedPixels = 1e-3f;
  const glm::vec2 target(q.u, q.v);
  glm::vec2 x = guess;
  glm::vec2 best = guess;
  float leastError = 1e30f;
  float damping = 1;
  float lastError = 1e30f;
  for (int step = 0; step < kMaxSteps && leastError >= kExactPixels; ++step) {
    const ImagePoint image = distort({x.x, x.y, q.t});
    const glm::vec2 residual = target - glm::vec2(image.u, image.v);
    const float error = glm::length(residual);
    if (error < leastError) {
      leastError = error;
      best = x;
    }
    damping = error > lastError ? std::max(damping * 0.5f, 0.1f) : damping;
    lastError = error;
    x += residual * damping;
  }
  return leastError < kAcceptedPixels ? std::optional(ImagePoint{best.x, best.y, q.t}) : std::nullopt;
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
  if (map_.at(pixel.x, pixel.y).displacement == glm::vec2(0)) {
    return path;  // what the pinhole sees here stays, at every depth
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
  // Straight up to the nearest z_n and beyond the farthest z_f of those; in between, equal steps of 1/z, about a
  // quarter of a pixel apart, several at a time where the ray is straight. Each is solved from the solution before it,
  // starting where the last two point. A step without a solution is left out: the ray goes straight over it, or ends
  // before it where none follows.
  constexpr float kStepsPerPixel = 4;
  constexpr float kMaxSteps = 96;
  constexpr int kMaxStride = 8;
  constexpr float kStraightPixels = 0.04f;  // off the line of the steps before: the chord is off by a part of it
  const int steps = static_cast<int>(std::clamp(reach * kStepsPerPixel, 4.0f, kMaxSteps));
  const auto inverseZAt = [&](float step) {
    return around.rampUpper + (around.rampLower - around.rampUpper) * (step / static_cast<float>(steps));
  };
  RayPath bent;
  bent.add(path.front(), path.tMin());
  glm::vec2 undistorted = pixel;
  glm::vec2 advance(0);  // for a step
  const auto solvedAt = [&](float inverseZ, const glm::vec2& guess) -> std::optional<glm::vec2> {
    const std::optional<ImagePoint> q = undistort({pixel.x, pixel.y, 1 / inverseZ}, guess);
    return q && reference_.unproject(*q) ? std::optional(glm::vec2(q->u, q->v)) : std::nullopt;
  };
  const auto add = [&](const glm::vec2& image, float inverseZ) {
    bent.add(*reference_.unproject({image.x, image.y, 1 / inverseZ}), 1 / inverseZ);
  };
  int stride = 1;
  for (int step = 0; step <= steps;) {
    // From the last step that is done, step - 1, by `stride` steps.
    stride = step == 0 ? 1 : std::min(stride, steps + 1 - step);
    const int to = step + stride - 1;
    const float inverseZ = inverseZAt(static_cast<float>(to));
    const glm::vec2 ahead = undistorted + advance * static_cast<float>(stride);
    const std::optional<glm::vec2> end = solvedAt(inverseZ, ahead);
    const bool isStraight = stride == 1 || (end && glm::distance(*end, ahead) <= kStraightPixels);
    if (!isStraight) {
      stride /= 2;
      continue;
    }
    if (end) {
      add(*end, inverseZ);
      advance = (*end - undistorted) / static_cast<float>(stride);
      undistorted = *end;
    }
    step += stride;
    stride = end ? std::min(stride * 2, kMaxStride) : 1;
  }
  const float inverseFar = 1 / reference_.view().zFar;
  if (const std::optional<glm::vec2> end = solvedAt(inverseFar, undistorted)) {
    add(*end, inverseFar);
  }
  return bent;
}

}  // namespace ocelli
