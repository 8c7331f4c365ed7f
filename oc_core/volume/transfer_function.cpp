#include "oc_core/volume/transfer_function.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {

TransferFunction::TransferFunction(std::vector<TransferPoint> points, double opacityLength)
    : points_(std::move(points)), opacityLength_(opacityLength) {
  OC_CHECK(!points_.empty() && opacityLength_ > 0, "a transfer function has points and an opacity length");
  OC_CHECK(std::ranges::is_sorted(points_, {}, &TransferPoint::value), "points of a transfer function are in order");
}

OpticalSample TransferFunction::at(double value) const {
  const auto next = std::ranges::upper_bound(points_, value, {}, &TransferPoint::value);
  const TransferPoint& above = next == points_.end() ? points_.back() : *next;
  const TransferPoint& below = next == points_.begin() ? points_.front() : *(next - 1);
  const double range = above.value - below.value;
  const double share = range > 0 ? (value - below.value) / range : 0;
  const double opacity = std::min(std::lerp(below.opacity, above.opacity, share), kMaxOpacity);
  return {glm::mix(below.color, above.color, share), -std::log1p(-opacity) / opacityLength_};
}

}  // namespace ocelli
