#include "oc_core/shade/shaded_on_device.h"

#include <algorithm>
#include <chrono>
#include <map>

namespace ocelli {
namespace {

/// Rays of an order.
struct RayOrder {
  std::vector<size_t> first;  ///< which of the first rays each comes from
  std::vector<SecondaryRay> rays;
  std::vector<const SceneProxy*> proxies;
  std::vector<ProxyHit> hits;
  std::vector<RayCost> costs;

  void add(size_t from, const SecondaryRay& ray, const SceneProxy& proxy) {
    first.push_back(from);
    rays.push_back(ray);
    proxies.push_back(&proxy);
  }

  void cast() {
    hits.resize(rays.size());
    costs.assign(rays.size(), {});
    std::map<const SceneProxy*, std::vector<size_t>> ofProxy;
    for (size_t i = 0; i < rays.size(); ++i) {
      ofProxy[proxies[i]].push_back(i);
    }
    for (const auto& [proxy, numbers] : ofProxy) {
      std::vector<SecondaryRay> own;
      for (const size_t i : numbers) {
        own.push_back(rays[i]);
      }
      std::vector<ProxyHit> found(own.size());
      std::vector<RayCost> spent(own.size());
      proxy->hitsOnDevice(own, found, spent);
      for (size_t k = 0; k < numbers.size(); ++k) {
        hits[numbers[k]] = found[k];
        costs[numbers[k]] = spent[k];
      }
    }
  }
};

bool areOnDevice(const std::vector<BuiltProxy>& proxies) {
  return std::all_of(proxies.begin(), proxies.end(), [](const BuiltProxy& built) { return built.proxy->isOnDevice(); });
}

/// One run; time is left out.
ShadedPicture castOrders(const SecondaryRays& rays, const SenderProxies& proxies, int order) {
  const size_t count = rays.rays.size();
  ShadedPicture picture{
      .color = rays.base, .hits = std::vector<ProxyHit>(count), .stepsOfRay = std::vector<uint32_t>(count)};
  if (order > 1) {
    picture.seconds.resize(count);
  }
  RayOrder now;
  for (size_t i = 0; i < count; ++i) {
    now.add(i, rays.rays[i], proxies.ofSender(rays.rays[i].sender));
  }
  std::vector<uint32_t> mirrors(count);  // that the rays of this order come from
  for (int reflections = 1; !now.rays.empty(); ++reflections) {
    now.cast();
    RayOrder next;
    for (size_t k = 0; k < now.rays.size(); ++k) {
      const size_t i = now.first[k];
      const ProxyHit& seen = now.hits[k];
      SecondaryRay ray = now.rays[k];
      picture.cost += now.costs[k];
      picture.stepsOfRay[i] += static_cast<uint32_t>(now.costs[k].steps());
      picture.color[rays.rays[i].pixel] = seen.color;
      if (reflections == 1) {
        picture.hits[i] = seen;
      } else if (reflections == 2 && seen.onCast) {
        picture.seconds[i] = SecondHit{mirrors[i], ray.origin + ray.direction * *seen.distance};
      }
      if (reflections < order && seen.mirror) {
        mirrors[i] = seen.mirror->mirror;
        ray.origin += ray.direction * *seen.distance;
        ray.direction = reflectedAt(*seen.mirror, ray.direction);
        next.add(i, ray, proxies.ofMirror(seen.mirror->mirror));
      }
    }
    now = std::move(next);
  }
  return picture;
}

}  // namespace

std::optional<ShadedPicture> shadeOnDevice(const SecondaryRays& rays, const SenderProxies& proxies, int order,
                                           int runs) {
  if (!areOnDevice(proxies.senders) || !areOnDevice(proxies.mirrors)) {
    return std::nullopt;
  }
  ShadedPicture picture;
  double least = 0;
  for (int run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    picture = castOrders(rays, proxies, order);
    const double taken = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    least = run == 0 ? taken : std::min(least, taken);
  }
  picture.milliseconds = least;
  return picture;
}

}  // namespace ocelli
