// Whether two neighbouring samples of a reference image lie on one surface: the criteria of image_mesh.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "oc_core/camera/camera.h"
#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

/// Pixels between the undistorted places of two samples.
inline float undistortedDistance(const ImagePoint& a, const ImagePoint& b) {
  return glm::distance(glm::vec2(a.u, a.v), glm::vec2(b.u, b.v));
}

/// Neighbours farther apart than this get no more tolerance of depth for it: a longer join is more likely to be a skin
/// across a gap.
inline constexpr float kLongestScaledStep = 1.5f;

/// Whether two depths differ by no more than the step that joins neighbours so many steps apart.
inline bool depthsJoin(float a, float b, float footprint, float steps, const ImageMeshOptions& options) {
  return std::abs(a - b) <= options.depthStepFootprints * footprint * std::clamp(steps, 1.0f, kLongestScaledStep);
}

/// By how much the step of 1/z between two depths may differ from the one beside it on the same surface.
inline float slopeTolerance(float a, float b, float footprint, const ImageMeshOptions& options) {
  return options.slopeToleranceFootprints * footprint / (a * b);
}

/// What two undistorted samples say alone: that they join, that they do not, or nothing, where their neighbours decide.
inline std::optional<bool> samplesJoinByThemselves(const ImagePoint& a, const ImagePoint& b, float focalPixels,
                                                   float spacing, const ImageMeshOptions& options) {
  const float distance = undistortedDistance(a, b);
  if (!(a.t > 0) || !(b.t > 0) || !(distance <= options.longestStepPixels)) {
    return false;
  }
  const float footprint = std::min(a.t, b.t) / focalPixels * spacing;
  return depthsJoin(a.t, b.t, footprint, distance / spacing, options) ? std::optional(true) : std::nullopt;
}

/// Undistorted samples, with the ones before a and after b in the same direction; z = 0 where there is none. They are
/// `evenSteps` where samples of a plane have equal steps of 1/z, however far apart they are undistorted. `spacing` is
/// what lies between neighbours on a surface that faces the pinhole, pixels.
inline bool samplesJoin(const ImagePoint& before, const ImagePoint& a, const ImagePoint& b, const ImagePoint& after,
                        bool evenSteps, float focalPixels, float spacing, const ImageMeshOptions& options) {
  if (const std::optional<bool> sure = samplesJoinByThemselves(a, b, focalPixels, spacing, options)) {
    return *sure;
  }
  const float distance = undistortedDistance(a, b);
  const float footprint = std::min(a.t, b.t) / focalPixels * spacing;
  // A grazing or a stretched surface: large steps of z, but 1/z goes on as on one of the two sides.
  const float tolerance = slopeTolerance(a.t, b.t, footprint, options);
  const float step = 1 / b.t - 1 / a.t;
  const auto goesOn = [&](const ImagePoint& p, const ImagePoint& q) {
    if (!(p.t > 0) || !(q.t > 0)) {
      return false;
    }
    const float other = 1 / q.t - 1 / p.t;
    const float slope = other / std::max(undistortedDistance(p, q), 0.1f);
    return std::abs(step - slope * distance) <= tolerance || (evenSteps && std::abs(step - other) <= tolerance);
  };
  return goesOn(before, a) || goesOn(b, after);
}

/// A sample of an image that displaces no pinhole's: whether there is one, where, and the way of its ray there.
struct PlacedSample {
  glm::vec3 position{0};
  glm::vec3 direction{0};
  bool held = false;
};

/// Two neighbouring samples as the ray of the farther one sees them: how far the nearer one lies beside it, which is
/// the distance between the rays there, and how much nearer it is.
struct PlacedStep {
  float footprint = 0;
  float depth = 0;
};
inline PlacedStep stepBetween(const PlacedSample& a, const PlacedSample& b) {
  const glm::vec3 between = b.position - a.position;
  const glm::vec3& ray = glm::dot(between, a.direction) > 0 ? b.direction : a.direction;
  const float along = glm::dot(between, ray);
  return {glm::length(between - ray * along), std::abs(along)};
}

/// Whether `b` lies where the line through `before` and `a` goes on: a plane's samples along a row or column of
/// straight rays lie on a line, however far apart the rays hit it.
inline bool goesOnStraight(const PlacedSample& before, const PlacedSample& a, const PlacedSample& b, float tolerance) {
  /// On a plane, a step is at most this many times as long as the one before.
  constexpr float kLongestGrowth = 4;
  if (!before.held) {
    return false;
  }
  const glm::vec3 line = a.position - before.position;
  const glm::vec3 step = b.position - a.position;
  const float length = glm::length(line);
  const float along = length > 0 ? glm::dot(step, line) / length : 0;
  return along > 0 && along <= kLongestGrowth * length && glm::length(glm::cross(step, line)) <= tolerance * length;
}

/// As samplesJoin(), without a pinhole: the footprint is that of the rays themselves. It may be far larger along one
/// direction of the image than along the other, `across`, so steps of depth are judged by the smaller one.
inline bool placedSamplesJoin(const PlacedSample& before, const PlacedSample& a, const PlacedSample& b,
                              const PlacedSample& after, float across, const ImageMeshOptions& options) {
  if (!a.held || !b.held) {
    return false;
  }
  const auto [footprint, depth] = stepBetween(a, b);
  const float tolerance = options.slopeToleranceFootprints * footprint;
  return depth <= options.placedStepFootprints * std::min(footprint, across) ||
         goesOnStraight(before, a, b, tolerance) || goesOnStraight(after, b, a, tolerance);
}

}  // namespace ocelli
