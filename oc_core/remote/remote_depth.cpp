#include "oc_core/remote/remote_depth.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ocelli {
namespace {

struct InverseRange {
  double far = 1;
  double near = 1;
};

/// Of 1/z; nothing where nothing is seen.
std::optional<InverseRange> inverseRange(const Image<float>& t) {
  float nearest = 0;
  float farthest = 0;
  for (const float z : t) {
    if (z > 0) {
      nearest = nearest > 0 ? std::min(nearest, z) : z;
      farthest = std::max(farthest, z);
    }
  }
  return nearest > 0 ? std::optional(InverseRange{1 / static_cast<double>(farthest), 1 / static_cast<double>(nearest)})
                     : std::nullopt;
}

}  // namespace

RemoteDepth roundedDepth(const Image<float>& t, int levels) {
  const InverseRange range = inverseRange(t).value_or(InverseRange{});
  RemoteDepth depth{.values = Image<uint16_t>(t.width(), t.height()),
                    .inverseNear = range.near,
                    .inverseFar = range.far,
                    .levels = std::clamp(levels, RemoteDepth::kMinLevels, RemoteDepth::kMaxLevels)};
  const double steps = range.near > range.far ? (depth.levels - 1) / (range.near - range.far) : 0;
  for (size_t i = 0; i < t.size(); ++i) {
    if (t[i] > 0) {
      const double step = std::round((1 / static_cast<double>(t[i]) - range.far) * steps);
      depth.values[i] = static_cast<uint16_t>(1 + std::clamp(static_cast<int>(step), 0, depth.levels - 1));
    }
  }
  return depth;
}

int depthLevels(const Image<float>& t, double focalPixels, double translation, double error) {
  const std::optional<InverseRange> range = inverseRange(t);
  if (!range) {
    return RemoteDepth::kMinLevels;
  }
  // The eye moves by translation / near, and with it a sample by that times focalPixels / z. Rounding is off by half a
  // step at most.
  const double steps = focalPixels * translation * (1 - range->far / range->near) / (2 * error);
  return static_cast<int>(
      std::clamp(std::ceil(steps) + 1, double{RemoteDepth::kMinLevels}, double{RemoteDepth::kMaxLevels}));
}

}  // namespace ocelli
