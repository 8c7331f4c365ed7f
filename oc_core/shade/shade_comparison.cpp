#include "oc_core/shade/shade_comparison.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/evaluation/image_quality.h"
#include "oc_core/ocri/coverage.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kChunks = 256;

ShadedPicture blankPicture(const SecondaryRays& rays) {
  return {rays.base, std::vector<ProxyHit>(rays.rays.size()), std::vector<uint32_t>(rays.rays.size())};
}

/// Time and cost of a run that began at `start`.
void addRun(ShadedPicture& picture, int run, Clock::time_point start, const std::vector<RayCost>& costs) {
  const double taken = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  picture.milliseconds = run == 0 ? taken : std::min(picture.milliseconds, taken);
  picture.cost = {};
  for (const RayCost& cost : costs) {
    picture.cost += cost;
  }
}

void colorPixels(const SecondaryRays& rays, ShadedPicture& picture) {
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    picture.color[rays.rays[i].pixel] = picture.hits[i].color;
  }
}

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

HitState stateOf(const SecondaryRay& ray, const ProxyHit& truth, const ProxyHit& seen, const PinholeCamera& reference) {
  if (seen.onCast) {
    const float near = nearReach(reference, placeOf(ray, *seen.distance));
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
  const float near = nearReach(reference, placeOf(ray, *truth.distance));
  return std::abs(*seen.distance - *truth.distance) <= near ? HitState::kRight : HitState::kOff;
}

Rgb8 heat(double share) {
  const auto part = [&](double from, double to) {
    return static_cast<uint8_t>(255 * std::clamp((share - from) / (to - from), 0.0, 1.0));
  };
  return {part(0.25, 0.6), part(0.6, 1), std::max(static_cast<uint8_t>(60 - part(0, 1) / 5), part(0.8, 1))};
}

}  // namespace

ShadedPicture shade(const SecondaryRays& rays, const SceneProxy& proxy, int runs) {
  ShadedPicture picture = blankPicture(rays);
  picture.onDevice = true;
  std::vector<RayCost> costs(rays.rays.size());
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    if (!proxy.hitsOnDevice(rays.rays, picture.hits, costs)) {
      return shadeOnCpu(rays, proxy, runs);
    }
    addRun(picture, run, start, costs);
  }
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    picture.stepsOfRay[i] = static_cast<uint32_t>(costs[i].steps());
  }
  colorPixels(rays, picture);
  return picture;
}

ShadedPicture shadeOnCpu(const SecondaryRays& rays, const SceneProxy& proxy, int runs) {
  ShadedPicture picture = blankPicture(rays);
  for (int run = 0; run < runs; ++run) {
    std::vector<RayCost> costs(kChunks);
    const auto start = Clock::now();
    parallelChunks(rays.rays.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t before = costs[chunk].steps();
        picture.hits[i] = proxy.hit(rays.rays[i], costs[chunk]);
        picture.stepsOfRay[i] = static_cast<uint32_t>(costs[chunk].steps() - before);
      }
    });
    addRun(picture, run, start, costs);
  }
  colorPixels(rays, picture);
  return picture;
}

size_t differingRays(const ShadedPicture& a, const ShadedPicture& b) {
  OC_CHECK(a.hits.size() == b.hits.size(), "pictures of the same rays");
  constexpr float kNear = 1e-4f;  // of the distance: a hundred roundings and more
  constexpr float kGrey = 1.0f / 255;
  size_t differing = 0;
  for (size_t i = 0; i < a.hits.size(); ++i) {
    const ProxyHit& p = a.hits[i];
    const ProxyHit& q = b.hits[i];
    const glm::vec3 step = glm::abs(p.color - q.color);
    differing += p.onCast != q.onCast || p.distance.has_value() != q.distance.has_value() ||
                 (p.distance && std::abs(*p.distance - *q.distance) > kNear * *p.distance) ||
                 std::max({step.x, step.y, step.z}) > kGrey;
  }
  return differing;
}

std::vector<HitState> compareHits(const SecondaryRays& rays, const ShadedPicture& truth, const ShadedPicture& picture,
                                  const PinholeCamera& reference) {
  std::vector<HitState> states(rays.rays.size());
  for (size_t i = 0; i < states.size(); ++i) {
    states[i] = stateOf(rays.rays[i], truth.hits[i], picture.hits[i], reference);
  }
  return states;
}

ShadeFigures figuresOf(const BuiltProxy& built, const SecondaryRays& rays, const ShadedPicture& truth,
                       const ShadedPicture& picture, const PinholeCamera& reference) {
  ShadeFigures figures{.name = built.name};
  figures.rays = rays.rays.size();
  figures.hasDepth = built.proxy->hasDepth();
  const std::vector<HitState> states = compareHits(rays, truth, picture, reference);
  for (size_t i = 0; i < states.size(); ++i) {
    const bool onCast = truth.hits[i].onCast;
    figures.castRays += onCast;
    figures.lost += onCast && states[i] != HitState::kRight;
    figures.missing += states[i] == HitState::kMissing;
    figures.falseHits += states[i] == HitState::kFalse;
    figures.maxSteps = std::max(figures.maxSteps, picture.stepsOfRay[i]);
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
