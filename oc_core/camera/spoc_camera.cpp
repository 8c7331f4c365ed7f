#include "oc_core/camera/spoc_camera.h"

#include <vector>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// What a coordinate of unit vectors lies between that point along (x, y), x in [x0, x1], |y| in [y0, y1].
glm::vec2 coordinateRange(float x0, float x1, float y0, float y1) {
  const auto share = [](float x, float y) { return x == 0 ? 0 : x / std::sqrt(x * x + y * y); };
  return {share(x0, x0 < 0 ? y0 : y1), share(x1, x1 > 0 ? y0 : y1)};
}

/// The least and the greatest distance from 0 in [lower, upper].
glm::vec2 distanceRange(float lower, float upper) {
  const float far = std::max(std::abs(lower), std::abs(upper));
  return {lower <= 0 && upper >= 0 ? 0 : std::min(std::abs(lower), std::abs(upper)), far};
}

}  // namespace

SpocCamera::SpocCamera(const PinholeCamera& reference, const SpocDistortion& d)
    : reference_(reference), distortion_(d), inverseNear_(1 / d.zNear), perInverseZ_(1 / (inverseNear_ - 1 / d.zFar)) {
  const std::string where = "single pole occlusion camera";
  if (!std::isfinite(d.pole.x) || !std::isfinite(d.pole.y) || !std::isfinite(d.zNear) || !std::isfinite(d.zFar) ||
      !std::isfinite(d.nearPixels) || !std::isfinite(d.farPixels)) {
    throw InputError("its distortion has a number that is not finite", where, "give finite numbers");
  }
  if (!(d.zNear > 0) || !(d.zFar > d.zNear) || !std::isfinite(perInverseZ_)) {
    throw InputError("its distortion has no range of depths", where, "choose z_n positive and less than z_f");
  }
  const float most = 10 * std::hypot(static_cast<float>(width()), static_cast<float>(height()));
  if (!(d.nearPixels >= 0) || !(d.farPixels >= d.nearPixels) || !(d.farPixels <= most)) {
    throw InputError("its displacements must not be negative, shrink with depth or exceed 10 image diagonals", where,
                     "choose 0 <= d_n <= d_f");
  }
}

SpocCamera SpocCamera::aroundObject(const PinholeCamera& reference, std::span<const glm::vec3> object,
                                    std::span<const glm::vec3> scene, const SpocOptions& options) {
  const std::string where = "single pole occlusion camera";
  const auto inView = [&](const glm::vec3& point) {
    const std::optional<ImagePoint> q = reference.project(point);
    const bool inside = q && q->u >= 0 && q->v >= 0 && q->u <= static_cast<float>(reference.width()) &&
                        q->v <= static_cast<float>(reference.height());
    return inside ? q : std::nullopt;
  };
  std::vector<ImagePoint> images;
  glm::dvec2 sum(0);
  for (const glm::vec3& point : object) {
    if (const std::optional<ImagePoint> q = inView(point)) {
      images.push_back(*q);
      sum += glm::dvec2(q->u, q->v);
    }
  }
  if (images.empty()) {
    throw InputError("no point of the object that it looks around is in view", where,
                     "turn the view towards the object, or choose another one");
  }
  const glm::vec2 pole(sum / static_cast<double>(images.size()));
  const auto fromPole = [&](const ImagePoint& q) { return glm::distance(glm::vec2(q.u, q.v), pole); };

  // Where the pole meets the object: its front among the points about as near to the pole as any.
  float nearestToPole = std::numeric_limits<float>::max();
  for (const ImagePoint& q : images) {
    nearestToPole = std::min(nearestToPole, fromPole(q));
  }
  const float radius = nearestToPole + static_cast<float>(reference.height()) / 100;
  SpocDistortion distortion{pole, std::numeric_limits<float>::max()};
  for (const ImagePoint& q : images) {
    if (!options.maskPole || fromPole(q) <= radius) {
      distortion.zNear = std::min(distortion.zNear, q.t);
    }
  }
  for (const glm::vec3& point : scene) {
    if (const std::optional<ImagePoint> q = inView(point)) {
      distortion.zFar = std::max(distortion.zFar, q->t);
    }
  }
  distortion.farPixels = options.farDisplacementPerHeight * static_cast<float>(reference.height());
  return {reference, distortion};
}

std::optional<ImagePoint> SpocCamera::project(const glm::vec3& worldPoint) const {
  const std::optional<ImagePoint> undistorted = reference_.project(worldPoint);
  if (!undistorted ||
      (glm::vec2(undistorted->u, undistorted->v) == distortion_.pole && displacementAt(undistorted->t) > 0)) {
    return std::nullopt;
  }
  return distort(*undistorted);
}

std::optional<ImagePoint> SpocCamera::undistort(const ImagePoint& q) const {
  const float displacement = displacementAt(q.t);
  if (displacement == 0) {
    return q;
  }
  const glm::vec2 fromPole = glm::vec2(q.u, q.v) - distortion_.pole;
  const float distance = glm::length(fromPole);
  if (!(distance > displacement)) {
    return std::nullopt;
  }
  const glm::vec2 undistorted = distortion_.pole + fromPole * ((distance - displacement) / distance);
  return ImagePoint{undistorted.x, undistorted.y, q.t};
}

std::optional<glm::vec3> SpocCamera::unproject(const ImagePoint& q) const {
  if (!reference_.unproject(q)) {  // not finite, or out of the depth range
    return std::nullopt;
  }
  const std::optional<ImagePoint> undistorted = undistort(q);
  return undistorted ? reference_.unproject(*undistorted) : std::nullopt;
}

RayPath SpocCamera::rayPath(const glm::vec2& pixel) const {
  if (distortion_.farPixels == 0) {
    return reference_.rayPath(pixel);
  }
  const float zFirst = reference_.view().zNear;
  const float zLast = reference_.view().zFar;
  const float fromPole = glm::distance(pixel, distortion_.pole);
  const float rangePixels = distortion_.farPixels - distortion_.nearPixels;
  // The ray ends a hair before the pole, where rounding cannot carry it over.
  constexpr float kBeforePole = 1e-3f;
  const float longest = fromPole - kBeforePole;

  RayPath path;
  const auto addPointAt = [&](float z, float displacement) {
    const glm::vec2 undistorted =
        displacement > 0 ? distortion_.pole + (pixel - distortion_.pole) * ((fromPole - displacement) / fromPole)
                         : pixel;
    if (const std::optional<glm::vec3> point = reference_.unproject({undistorted.x, undistorted.y, z})) {
      path.add(*point, z);
    }
  };
  if (displacementAt(zFirst) > std::max(longest, 0.0f)) {
    return path;
  }
  addPointAt(zFirst, displacementAt(zFirst));
  if (path.empty()) {  // not a number
    return path;
  }
  const float zNear = distortion_.zNear;
  if (zNear > zFirst && zNear < zLast) {
    // Either the corner of the ray or, where the projection jumps, its step aside, over less than anything seen.
    constexpr float kStep = 1e-5f;
    addPointAt(distortion_.nearPixels > 0 ? zNear * (1 - kStep) : zNear, 0);
    if (distortion_.nearPixels > longest) {
      return path;
    }
    if (distortion_.nearPixels > 0) {
      addPointAt(zNear, distortion_.nearPixels);
    }
  }
  if (distortion_.farPixels <= longest) {
    if (distortion_.zFar > zFirst && distortion_.zFar < zLast) {
      addPointAt(distortion_.zFar, distortion_.farPixels);
    }
    addPointAt(zLast, displacementAt(zLast));
  } else if (longest > distortion_.nearPixels) {
    const float zReached = 1 / (inverseNear_ - (longest - distortion_.nearPixels) / rangePixels / perInverseZ_);
    if (zReached >= zLast) {
      addPointAt(zLast, displacementAt(zLast));
    } else if (zReached > std::max(zFirst, zNear)) {
      addPointAt(zReached, longest);
    }
  }
  return path;
}

ImageBox SpocCamera::displacementOver(const ImageBox& undistorted, float minInverseZ, float greatestInverseZ) const {
  const float least = displacementAt(1 / greatestInverseZ);
  const float greatest = displacementAt(1 / minInverseZ);
  const glm::vec2 lower = undistorted.lower - distortion_.pole;
  const glm::vec2 upper = undistorted.upper - distortion_.pole;
  const glm::vec2 distanceU = distanceRange(lower.x, upper.x);
  const glm::vec2 distanceV = distanceRange(lower.y, upper.y);
  if (distanceU.x == 0 && distanceV.x == 0) {  // the pole is in the box
    return {glm::vec2(-greatest), glm::vec2(greatest)};
  }
  const glm::vec2 directionU = coordinateRange(lower.x, upper.x, distanceV.x, distanceV.y);
  const glm::vec2 directionV = coordinateRange(lower.y, upper.y, distanceU.x, distanceU.y);
  return scaled({{directionU.x, directionV.x}, {directionU.y, directionV.y}}, least, greatest);
}

}  // namespace ocelli
