#include "oc_core/shade/shade_comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/check.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/image/image_error.h"
#include "oc_core/ocri/coverage.h"

namespace ocelli {
namespace {

/// The linear colours of the rays' pixels alone, as an image of one row.
Image<Rgb8> colorsOfRays(const SecondaryRays& rays, const ShadedPicture& picture) {
  Image<glm::vec3> row(static_cast<int>(rays.rays.size()), 1);
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    row[i] = picture.color[rays.rays[i].pixel];
  }
  return srgbFromLinear(row);
}

glm::vec3 placeOf(const SecondaryRay& ray, float distance) {
  return ray.origin + ray.direction * distance;
}

/// What counts as near. Of things beside and behind the reference view, which no image of one plane holds, the distance
/// stands for z.
float reachAt(const PinholeCamera& reference, const glm::vec3& place) {
  const float along = reference.cameraFromWorld(place).z;
  const float distance = glm::distance(place, reference.eye());
  const bool isAhead = along > 0.1f * distance;  // no reference view reaches farther aside
  return isAhead ? nearReach(reference, place) : kNearFootprints * distance / reference.focalPixels();
}

HitState stateOf(const SecondaryRay& ray, const ProxyHit& truth, const ProxyHit& seen, const PinholeCamera& reference) {
  if (seen.onCast) {
    const float near = reachAt(reference, placeOf(ray, *seen.distance));
    if (!truth.distance || *seen.distance < *truth.distance - near) {
      return HitState::kFalse;
    }
  }
  if (!truth.onCast) {
    return HitState::kElsewhere;
  }
  if (!seen.onCast) {
    return HitState::kMissing;
  }
  const float near = reachAt(reference, placeOf(ray, *truth.distance));
  return std::abs(*seen.distance - *truth.distance) <= near ? HitState::kRight : HitState::kOff;
}

float footprintAt(const SecondaryRay& ray, float distance, const Yardsticks& yardsticks) {
  return reachAt(yardsticks.senders[ray.sender], placeOf(ray, distance)) / kNearFootprints;
}

bool isNear(const SecondHit& truth, const std::optional<SecondHit>& seen, const Yardsticks& yardsticks) {
  return seen &&
         glm::distance(truth.position, seen->position) <= reachAt(yardsticks.ofMirror(truth.mirror), truth.position);
}

Rgb8 heat(double share) {
  const auto part = [&](double from, double to) {
    return static_cast<uint8_t>(255 * std::clamp((share - from) / (to - from), 0.0, 1.0));
  };
  return {part(0.25, 0.6), part(0.6, 1), std::max(static_cast<uint8_t>(60 - part(0, 1) / 5), part(0.8, 1))};
}

}  // namespace

std::vector<HitState> compareHits(const SecondaryRays& rays, const ShadedPicture& truth, const ShadedPicture& picture,
                                  const Yardsticks& yardsticks) {
  std::vector<HitState> states(rays.rays.size());
  for (size_t i = 0; i < states.size(); ++i) {
    states[i] = stateOf(rays.rays[i], truth.hits[i], picture.hits[i], yardsticks.senders[rays.rays[i].sender]);
  }
  return states;
}

ShadeFigures figuresOf(const BuiltProxy& built, const SecondaryRays& rays, const ShadedPicture& truth,
                       const ShadedPicture& picture, const Yardsticks& yardsticks) {
  ShadeFigures figures{.name = built.name};
  figures.rays = rays.rays.size();
  figures.hasDepth = built.hasDepth;
  const std::vector<HitState> states = compareHits(rays, truth, picture, yardsticks);
  for (size_t i = 0; i < states.size(); ++i) {
    const bool onCast = truth.hits[i].onCast;
    figures.castRays += onCast;
    if (onCast) {
      figures.footprint += static_cast<double>(footprintAt(rays.rays[i], *truth.hits[i].distance, yardsticks));
    }
    figures.lost += onCast && states[i] != HitState::kRight;
    figures.missing += states[i] == HitState::kMissing;
    figures.falseHits += states[i] == HitState::kFalse;
    figures.maxSteps = std::max(figures.maxSteps, picture.stepsOfRay[i]);
  }
  figures.footprint /= std::max(static_cast<double>(figures.castRays), 1.0);
  for (size_t i = 0; i < std::min(truth.seconds.size(), picture.seconds.size()); ++i) {
    if (truth.seconds[i]) {
      ++figures.secondRays;
      figures.secondLost += !isNear(*truth.seconds[i], picture.seconds[i], yardsticks);
    }
  }
  figures.psnrDecibels = psnrDecibels(meanSquaredError(colorsOfRays(rays, truth), colorsOfRays(rays, picture)));
  figures.cost = picture.cost;
  figures.samples = built.samples;
  figures.triangles = built.triangles;
  figures.buildMilliseconds = built.buildMilliseconds;
  figures.structureMilliseconds = built.structureMilliseconds;
  figures.shadeMilliseconds = picture.milliseconds;
  return figures;
}

size_t differingRays(const SecondaryRays& rays, const ShadedPicture& a, const ShadedPicture& b) {
  OC_CHECK(a.hits.size() == rays.rays.size() && b.hits.size() == rays.rays.size(), "pictures of these rays");
  constexpr float kNear = 1e-4f;  // of the distance: a hundred roundings and more
  constexpr float kGrey = 1.0f / 255;
  size_t differing = 0;
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    const ProxyHit& p = a.hits[i];
    const ProxyHit& q = b.hits[i];
    const glm::vec3 step = glm::abs(a.color[rays.rays[i].pixel] - b.color[rays.rays[i].pixel]);
    differing += p.onCast != q.onCast || p.distance.has_value() != q.distance.has_value() ||
                 (p.distance && std::abs(*p.distance - *q.distance) > kNear * *p.distance) ||
                 std::max({step.x, step.y, step.z}) > kGrey;
  }
  return differing;
}

Image<Rgb8> hitErrorImage(const SecondaryRays& rays, const ShadedPicture& truth, const std::vector<HitState>& states) {
  constexpr float kDimmed = 0.12f;
  Image<glm::vec3> dimmed(truth.color.width(), truth.color.height());
  for (size_t i = 0; i < dimmed.size(); ++i) {
    dimmed[i] = truth.color[i] * kDimmed;
  }
  Image<Rgb8> image = srgbFromLinear(dimmed);
  for (size_t i = 0; i < states.size(); ++i) {
    Rgb8& pixel = image[rays.rays[i].pixel];
    switch (states[i]) {
      case HitState::kElsewhere:
      case HitState::kRight:
        break;
      case HitState::kOff:
        pixel = kFalseSkinColor;
        break;
      case HitState::kMissing:
        pixel = kMissingColor;
        break;
      case HitState::kFalse:
        pixel = kWrongFrontColor;
        break;
    }
  }
  return image;
}

Image<Rgb8> stepImage(const SecondaryRays& rays, const ShadedPicture& picture, uint32_t brightest) {
  Image<Rgb8> image(picture.color.width(), picture.color.height(), Rgb8(200, 200, 200));
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    image[rays.rays[i].pixel] = heat(static_cast<double>(picture.stepsOfRay[i]) / std::max(brightest, 1u));
  }
  return image;
}

}  // namespace ocelli
