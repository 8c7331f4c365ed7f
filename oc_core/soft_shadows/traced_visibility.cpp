#include "oc_core/soft_shadows/traced_visibility.h"

#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// Rays end so much before the light, of its distance: a panel of the scene may stand where it is.
constexpr float kBeforeLight = 1e-4f;
constexpr size_t kReceiversATask = 64;

}  // namespace

TracedVisibility::TracedVisibility(const Mesh& occluders, const AreaLight& light, int rays, const ReceiverLift& lift)
    : frame_(light), lift_(lift), rays_(occluders) {
  OC_CHECK(rays >= 1 && rays <= kMaxRays, "a number of rays out of range");
  columns_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(rays))));
  while (rays % columns_ != 0) {
    --columns_;
  }
  rows_ = rays / columns_;
  if (frame_.half().x > frame_.half().y) {
    std::swap(columns_, rows_);
  }
}

/// Of a disc after P. Shirley and K. Chiu, A low distortion map between disk and square, 1997: strata keep their areas.
glm::vec3 TracedVisibility::onLight(const LightFrame& frame, const glm::vec2& unit) {
  glm::vec2 p = unit * 2.0f - 1.0f;
  if (frame.light().isDisc && (p.x != 0 || p.y != 0)) {
    const bool isWide = std::abs(p.x) > std::abs(p.y);
    const float radius = isWide ? p.x : p.y;
    const auto quarter = static_cast<float>(kPi / 4);
    const float angle = isWide ? quarter * (p.y / p.x) : 2 * quarter - quarter * (p.x / p.y);
    p = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return {p * frame.half(), 0};
}

LightVisibility TracedVisibility::of(std::span<const ShadowReceiver> receivers) const {
  LightVisibility result;
  result.share.assign(receivers.size(), 0);
  std::vector<uint32_t> cast(receivers.size(), 0);
  const auto raysEach = static_cast<size_t>(columns_ * rows_);
  parallelFor(receivers.size(), kReceiversATask, [&](size_t begin, size_t end) {
    std::vector<SightLine> lines(raysEach);
    std::vector<uint8_t> blocked(raysEach);
    for (size_t i = begin; i < end; ++i) {
      LitReceiver lit;
      if (!isLit(receivers[i], frame_, lift_, lit)) {
        continue;
      }
      Random random(i);
      const glm::vec3 from = frame_.toWorld(lit.position);
      size_t ray = 0;
      for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
          const float x = random.inRange(0, 1);
          const float y = random.inRange(0, 1);
          const glm::vec2 unit((static_cast<float>(column) + x) / static_cast<float>(columns_),
                               (static_cast<float>(row) + y) / static_cast<float>(rows_));
          const glm::vec3 place = onLight(frame_, unit);
          if (!lit.isAbove(place)) {
            continue;
          }
          const glm::vec3 to = frame_.toWorld(place);
          lines[ray++] = {from, to + (from - to) * kBeforeLight};
        }
      }
      rays_.find(std::span(lines).first(ray), std::span(blocked).first(ray));
      size_t free = ray;
      for (size_t each = 0; each < ray; ++each) {
        free -= blocked[each];
      }
      result.share[i] = static_cast<float>(free) / static_cast<float>(raysEach);
      cast[i] = static_cast<uint32_t>(ray);
    }
  });
  for (const uint32_t each : cast) {
    result.work.rays += each;
  }
  return result;
}

}  // namespace ocelli
