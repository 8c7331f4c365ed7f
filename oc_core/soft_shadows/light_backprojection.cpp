#include "oc_core/soft_shadows/light_backprojection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/soft_shadows/receiver_plane.h"

namespace ocelli {
namespace {

/// Of the light, in grid coordinates.
struct Patch {
  float left = 0, right = 0, top = 0, bottom = 0;
};

/// The back-projection for one receiver.
class BackProjector {
 public:
  BackProjector(const LightShadowMap& map, const LightGrid& grid) : map_(map), grid_(grid) {
    for (int row = 0; row < grid.side(); ++row) {
      for (int column = 0; column < grid.side(); ++column) {
        allOf_[static_cast<size_t>(row)] |= grid.isOnLight(column, row) ? 1u << column : 0;
      }
    }
  }

  float visibility(const LitReceiver& lit, uint64_t& looked) {
    const ReceiverPlane plane(lit);
    receiver_ = lit.position;
    plane_ = &plane;
    hidden_.fill(0);
    looked_ = 0;
    visit(map_.levels() - 1, 0, 0);
    looked += looked_;
    int seen = 0;
    for (size_t row = 0; row < static_cast<size_t>(grid_.side()); ++row) {
      seen += std::popcount(allOf_[row] & ~hidden_[row] & ~belowHorizon(lit, static_cast<int>(row)));
    }
    return static_cast<float>(seen) / static_cast<float>(grid_.count());
  }

 private:
  uint32_t belowHorizon(const LitReceiver& lit, int row) const {
    uint32_t bits = 0;
    for (int column = 0; lit.seesHorizon && column < grid_.side(); ++column) {
      bits |= lit.isAbove(grid_.point(column, row)) ? 0 : 1u << column;
    }
    return bits;
  }
  /// Around the texels from (x0, y0) to (x1, y1) at a depth.
  Patch projected(int x0, int y0, int x1, int y1, float depth) const {
    const float enlarged = receiver_.z / (receiver_.z - depth);
    const glm::vec2 from = onGrid(map_.slope({x0, y0}) * depth, enlarged);
    const glm::vec2 to = onGrid(map_.slope({x1, y1}) * depth, enlarged);
    return {std::min(from.x, to.x), std::max(from.x, to.x), std::min(from.y, to.y), std::max(from.y, to.y)};
  }
  glm::vec2 onGrid(const glm::vec2& point, float enlarged) const {
    const glm::vec2 p(receiver_);
    return (p + (point - p) * enlarged) * grid_.scale() + grid_.offset();
  }
  bool isNearer(int x, int y) const {
    return map_.leastDepths(0).contains(x, y) &&
           map_.depth(x, y) < plane_->depthAt(map_.slope({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
  }

  void visit(int level, int x, int y) {
    ++looked_;
    const float least = map_.leastDepths(level)(x, y);
    if (!(least < receiver_.z)) {
      return;
    }
    if (level == 0) {
      if (isNearer(x, y)) {
        hide(x, y);
      }
      return;
    }
    // Lines to the light pass depths from `least` to the receiver's within a window around the receiver's own place.
    const int side = 1 << level;
    const glm::vec2 middle = map_.texel(glm::vec2(receiver_) / receiver_.z);
    const glm::vec2 reach = glm::abs(map_.perSlope()) * half() * (1 / least - 1 / receiver_.z) + 2.0f;
    const auto x0 = static_cast<float>(x * side);
    const auto y0 = static_cast<float>(y * side);
    const auto length = static_cast<float>(side);
    if (x0 > middle.x + reach.x || x0 + length < middle.x - reach.x || y0 > middle.y + reach.y ||
        y0 + length < middle.y - reach.y) {
      return;
    }
    const Image<float>& below = map_.leastDepths(level - 1);
    for (int v = 2 * y; v < std::min(2 * y + 2, below.height()); ++v) {
      for (int u = 2 * x; u < std::min(2 * x + 2, below.width()); ++u) {
        visit(level - 1, u, v);
      }
    }
  }

  glm::vec2 half() const { return static_cast<float>(grid_.side()) / 2 / grid_.scale(); }

  void hide(int x, int y) {
    Patch patch = projected(x, y, x + 1, y + 1, map_.depth(x, y));
    const auto grow = [&](int u, int v) {
      if (!isNearer(u, v)) {
        return;
      }
      const Patch other = projected(u, v, u + 1, v + 1, map_.depth(u, v));
      if (u != x) {
        patch.right = std::max(patch.right, std::min(other.left, other.right));
        patch.left = std::min(patch.left, std::max(other.left, other.right));
      } else {
        patch.bottom = std::max(patch.bottom, other.top);
        patch.top = std::min(patch.top, other.bottom);
      }
    };
    grow(x + 1, y);
    grow(x, y + 1);
    const auto rows = static_cast<float>(grid_.side());
    if (!(patch.left < rows && patch.right > 0 && patch.top < rows && patch.bottom > -1)) {
      return;
    }
    const int firstRow = static_cast<int>(std::ceil(std::max(patch.top, 0.0f)));
    const int endRow = static_cast<int>(std::ceil(std::min(patch.bottom, rows)));
    for (int row = firstRow; row < endRow; ++row) {
      const float shift = grid_.shift(row);
      const int first = static_cast<int>(std::ceil(std::max(patch.left - shift, 0.0f)));
      const int end = static_cast<int>(std::ceil(std::clamp(patch.right - shift, 0.0f, rows)));
      if (first < end) {
        const uint64_t bits = (uint64_t{1} << end) - (uint64_t{1} << first);
        hidden_[static_cast<size_t>(row)] |= static_cast<uint32_t>(bits);
      }
    }
  }

  const LightShadowMap& map_;
  const LightGrid& grid_;
  std::array<uint32_t, LightGrid::kMaxSide> allOf_{};
  std::array<uint32_t, LightGrid::kMaxSide> hidden_{};
  glm::vec3 receiver_{0};
  const ReceiverPlane* plane_ = nullptr;
  uint64_t looked_ = 0;
};

}  // namespace

BackprojectedShadows::BackprojectedShadows(const LightShadowMap& map, const AreaLight& light,
                                           const BackprojectionOptions& options)
    : map_(map), frame_(light), options_(options), grid_(frame_, options.gridSide) {}

LightVisibility BackprojectedShadows::of(std::span<const ShadowReceiver> receivers) const {
  LightVisibility result;
  result.share.assign(receivers.size(), 0);
  std::vector<uint64_t> looked(receivers.size(), 0);
  parallelFor(receivers.size(), 64, [&](size_t begin, size_t end) {
    BackProjector projector(map_, grid_);
    for (size_t i = begin; i < end; ++i) {
      LitReceiver lit;
      if (isLit(receivers[i], frame_, options_.lift, lit)) {
        result.share[i] = projector.visibility(lit, looked[i]);
      }
    }
  });
  for (const uint64_t each : looked) {
    result.work.elements += each;
  }
  return result;
}

}  // namespace ocelli
