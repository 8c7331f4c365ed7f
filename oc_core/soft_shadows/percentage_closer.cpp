#include "oc_core/soft_shadows/percentage_closer.h"

#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/soft_shadows/receiver_plane.h"

namespace ocelli {
namespace {

/// Calls `visit(x, y, onLight)` for the texels at taps over the light's shape, scaled by `half` around `middle` (both
/// in slopes), in strata; for those beside the map too. `onLight` is the point of the light that a tap stands for.
template <class Visit>
void forTaps(const LightShadowMap& map, const LightFrame& frame, const glm::vec2& middle, const glm::vec2& half,
             int side, Random& random, const Visit& visit) {
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const float x = (static_cast<float>(column) + random.inRange(0, 1)) / static_cast<float>(side) * 2 - 1;
      const float y = (static_cast<float>(row) + random.inRange(0, 1)) / static_cast<float>(side) * 2 - 1;
      if (frame.light().isDisc && x * x + y * y > 1) {
        continue;
      }
      const glm::vec2 slope = middle + half * glm::vec2(x, y);
      const glm::vec2 texel = map.texel(slope);
      visit(static_cast<int>(std::floor(texel.x)), static_cast<int>(std::floor(texel.y)),
            glm::vec3(frame.half() * glm::vec2(x, y), 0));
    }
  }
}

}  // namespace

PercentageCloserShadows::PercentageCloserShadows(const LightShadowMap& map, const AreaLight& light,
                                                 const PercentageCloserOptions& options)
    : map_(map), frame_(light), options_(options) {}

LightVisibility PercentageCloserShadows::of(std::span<const ShadowReceiver> receivers) const {
  LightVisibility result;
  result.share.assign(receivers.size(), 0);
  std::vector<uint32_t> looked(receivers.size(), 0);
  const Image<float>& depths = map_.leastDepths(0);
  parallelFor(receivers.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      LitReceiver lit;
      if (!isLit(receivers[i], frame_, options_.lift, lit)) {
        continue;
      }
      Random random(i);
      const ReceiverPlane plane(lit);
      const glm::vec3& p = lit.position;
      const glm::vec2 middle(p.x / p.z, p.y / p.z);
      const auto isNearer = [&](int x, int y) {
        return depths.contains(x, y) &&
               depths(x, y) < plane.depthAt(map_.slope({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
      };
      result.share[i] = 1;
      const float nearest = map_.leastDepth();
      double sum = 0;
      int blockers = 0;
      forTaps(map_, frame_, middle, frame_.half() * std::max(0.0f, 1 / nearest - 1 / p.z), options_.searchTaps, random,
              [&](int x, int y, const glm::vec3&) {
                ++looked[i];
                if (isNearer(x, y)) {
                  sum += static_cast<double>(depths(x, y));
                  ++blockers;
                }
              });
      if (blockers == 0 && !lit.seesHorizon) {
        continue;
      }
      const auto mean = blockers > 0 ? static_cast<float>(sum / blockers) : p.z;
      int taps = 0;
      int nearer = 0;
      forTaps(map_, frame_, middle, frame_.half() * std::max(0.0f, 1 / mean - 1 / p.z), options_.filterTaps, random,
              [&](int x, int y, const glm::vec3& onLight) {
                ++looked[i];
                ++taps;
                nearer += !lit.isAbove(onLight) || isNearer(x, y) ? 1 : 0;
              });
      result.share[i] = 1 - static_cast<float>(nearer) / static_cast<float>(taps);
    }
  });
  for (const uint32_t each : looked) {
    result.work.elements += each;
  }
  return result;
}

}  // namespace ocelli
