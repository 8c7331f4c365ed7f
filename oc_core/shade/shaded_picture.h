// A picture of secondary rays by one of the ways: each ray sees what stands for the scene where it goes, and goes on
// from mirrors that it meets there, up to an order (section 3.5.2.3.1).
#pragma once

#include <string>
#include <vector>

#include "oc_core/image/image.h"
#include "oc_core/shade/scene_proxies.h"

namespace ocelli {

/// What stands for the scene, for the rays of each object that sends some.
struct SenderProxies {
  std::vector<BuiltProxy> senders;
  /// For rays that go on from ShadedScene::mirrors; empty where those are the senders.
  std::vector<BuiltProxy> mirrors = {};

  const SceneProxy& ofSender(uint32_t sender) const { return *senders[sender].proxy; }
  const SceneProxy& ofMirror(uint32_t mirror) const {
    return mirrors.empty() ? *senders[mirror].proxy : *mirrors[mirror].proxy;
  }
  /// Name, times and sizes of all together, without a proxy.
  BuiltProxy total() const;
};

/// What a ray that went on from a mirror met: one that depth images stand for.
struct SecondHit {
  uint32_t mirror = 0;
  glm::vec3 position{0};
};

struct ShadedPicture {
  Image<glm::vec3> color;            ///< linear
  std::vector<ProxyHit> hits;        ///< first ones, of each ray
  std::vector<uint32_t> stepsOfRay;  ///< of all its orders together
  RayCost cost = {};
  double milliseconds = 0;                             ///< of all rays, on all threads: the least of the runs
  std::vector<std::optional<SecondHit>> seconds = {};  ///< of each ray, where second-order rays are followed
};

/// Rays of at most `order` reflections, the one that sent them included, which for glass is its refraction. A mirror
/// that the last of them meets shows its own colour.
ShadedPicture shade(const SecondaryRays& rays, const SenderProxies& proxies, int order, int runs = 1);
/// At first order, for all that sends rays alike.
ShadedPicture shade(const SecondaryRays& rays, const SceneProxy& proxy, int runs = 1);

}  // namespace ocelli
