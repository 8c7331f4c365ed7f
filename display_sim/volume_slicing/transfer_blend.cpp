#include "display_sim/volume_slicing/transfer_blend.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Points between two points of either: opacity is linear in the value there, and a mean of extinctions is not.
constexpr int kPiecesBetween = 16;

/// A step lies between a value and the next number below it.
std::vector<double> valuesOf(const TransferFunction& from, const TransferFunction& to) {
  std::vector<double> corners;
  for (const TransferFunction* each : {&from, &to}) {
    for (const TransferPoint& point : each->points()) {
      corners.push_back(point.value);
      corners.push_back(std::nextafter(point.value, -std::numeric_limits<double>::infinity()));
    }
  }
  std::ranges::sort(corners);
  std::vector<double> values;
  for (size_t i = 0; i < corners.size(); ++i) {
    values.push_back(corners[i]);
    if (i + 1 < corners.size() &&
        corners[i + 1] > std::nextafter(corners[i], std::numeric_limits<double>::infinity())) {
      for (int k = 1; k < kPiecesBetween; ++k) {
        values.push_back(std::lerp(corners[i], corners[i + 1], static_cast<double>(k) / kPiecesBetween));
      }
    }
  }
  return values;
}

}  // namespace

TransferFunction blendedTransfer(const TransferFunction& from, const TransferFunction& to, double share) {
  const double length = from.opacityLength();
  std::vector<TransferPoint> points;
  for (const double value : valuesOf(from, to)) {
    const OpticalSample a = from.at(value);
    const OpticalSample b = to.at(value);
    const double extinction = std::lerp(a.extinction, b.extinction, share);
    const double ofB = extinction > 0 ? share * b.extinction / extinction : share;
    points.push_back({value, glm::mix(a.color, b.color, ofB), -std::expm1(-extinction * length)});
  }
  return {std::move(points), length};
}

TransferSwing::TransferSwing(TransferFunction from, TransferFunction to, double periodSeconds)
    : from_(std::move(from)), to_(std::move(to)), periodSeconds_(periodSeconds) {
  OC_CHECK(periodSeconds > 0, "a swing takes time");
}

TransferFunction TransferSwing::at(double seconds) const {
  const double periods = seconds / periodSeconds_;
  const double share = periods - std::floor(periods);
  return blendedTransfer(from_, to_, 1 - std::abs(1 - 2 * share));
}

}  // namespace ocelli
