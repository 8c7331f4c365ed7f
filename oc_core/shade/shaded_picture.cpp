#include "oc_core/shade/shaded_picture.h"

#include <algorithm>
#include <chrono>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kChunks = 256;

/// `follow(i, cost)` is the linear colour that ray `i` sees in the end.
template <class Follow>
ShadedPicture shadeRays(const SecondaryRays& rays, int runs, ShadedPicture picture, const Follow& follow) {
  std::vector<glm::vec3> colors(rays.rays.size());
  for (int run = 0; run < runs; ++run) {
    std::vector<RayCost> costs(kChunks);
    const auto start = std::chrono::steady_clock::now();
    parallelChunks(rays.rays.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const size_t before = costs[chunk].steps();
        colors[i] = follow(picture, i, costs[chunk]);
        picture.stepsOfRay[i] = static_cast<uint32_t>(costs[chunk].steps() - before);
      }
    });
    const double taken = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    picture.milliseconds = run == 0 ? taken : std::min(picture.milliseconds, taken);
    picture.cost = {};
    for (const RayCost& cost : costs) {
      picture.cost += cost;
    }
  }
  for (size_t i = 0; i < rays.rays.size(); ++i) {
    picture.color[rays.rays[i].pixel] = colors[i];
  }
  return picture;
}

ShadedPicture emptyPicture(const SecondaryRays& rays) {
  return {.color = rays.base,
          .hits = std::vector<ProxyHit>(rays.rays.size()),
          .stepsOfRay = std::vector<uint32_t>(rays.rays.size())};
}

}  // namespace

BuiltProxy SenderProxies::total() const {
  BuiltProxy total{.name = senders.front().name, .hasDepth = senders.front().hasDepth};
  for (const std::vector<BuiltProxy>* all : {&senders, &mirrors}) {
    for (const BuiltProxy& each : *all) {
      total.buildMilliseconds += each.buildMilliseconds;
      total.structureMilliseconds += each.structureMilliseconds;
      total.samples += each.samples;
      total.triangles += each.triangles;
    }
  }
  return total;
}

ShadedPicture shade(const SecondaryRays& rays, const SenderProxies& proxies, int order, int runs) {
  ShadedPicture empty = emptyPicture(rays);
  if (order > 1) {
    empty.seconds.resize(rays.rays.size());
  }
  return shadeRays(rays, runs, std::move(empty), [&](ShadedPicture& picture, size_t i, RayCost& cost) {
    SecondaryRay ray = rays.rays[i];
    ProxyHit seen = picture.hits[i] = proxies.ofSender(ray.sender).hit(ray, cost);
    for (int reflections = 1; reflections < order && seen.mirror; ++reflections) {
      const MetMirror met = *seen.mirror;
      ray.origin += ray.direction * *seen.distance;
      ray.direction = reflectedAt(met, ray.direction);
      seen = proxies.ofMirror(met.mirror).hit(ray, cost);
      if (reflections == 1 && seen.onCast) {
        picture.seconds[i] = SecondHit{met.mirror, ray.origin + ray.direction * *seen.distance};
      }
    }
    return seen.color;
  });
}

ShadedPicture shade(const SecondaryRays& rays, const SceneProxy& proxy, int runs) {
  return shadeRays(rays, runs, emptyPicture(rays), [&](ShadedPicture& picture, size_t i, RayCost& cost) {
    picture.hits[i] = proxy.hit(rays.rays[i], cost);
    return picture.hits[i].color;
  });
}

}  // namespace ocelli
