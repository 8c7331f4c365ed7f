#include "oc_core/volume/transfer_integral.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace ocelli {
namespace {

/// Less light passes no slab of the opacity length.
constexpr double kMinPassed = 1 - TransferFunction::kMaxOpacity;

/// What is linear in the value: how much light a slab of the opacity length passes, and its colour.
struct Passing {
  double passed;
  glm::dvec3 color;
};

Passing mixPassing(const Passing& a, const Passing& b, double share) {
  return {std::lerp(a.passed, b.passed, share), glm::mix(a.color, b.color, share)};
}

/// The mean of -ln(passed), and of colours times it, between two. Gauss's rule with five points: while one passes at
/// most twice as much as the other, the relative error is below 1e-7.
glm::dvec4 meanOfSmooth(const Passing& a, const Passing& b) {
  constexpr double kPlaces[] = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  glm::dvec4 sum(0);
  const auto add = [&](double place, double weight) {
    const Passing p = mixPassing(a, b, 0.5 + 0.5 * place);
    sum += weight / 2 * -std::log(p.passed) * glm::dvec4(1, p.color);
  };
  add(0, kWeights[0]);
  for (int i = 1; i < 3; ++i) {
    add(kPlaces[i], kWeights[i]);
    add(-kPlaces[i], kWeights[i]);
  }
  return sum;
}

/// The same for any two that pass something.
glm::dvec4 meanOfPassing(const Passing& a, const Passing& b) {
  if (std::max(a.passed, b.passed) <= 2 * std::min(a.passed, b.passed)) {
    return meanOfSmooth(a, b);
  }
  const double share = (std::sqrt(a.passed * b.passed) - a.passed) / (b.passed - a.passed);
  const Passing middle = mixPassing(a, b, share);
  return share * meanOfPassing(a, middle) + (1 - share) * meanOfPassing(middle, b);
}

/// The same for any two, of which one that passes less than the function's least counts as that.
glm::dvec4 meanBetween(Passing a, Passing b) {
  const auto bounded = [](Passing p) { return Passing{std::max(p.passed, kMinPassed), p.color}; };
  if ((a.passed < kMinPassed) == (b.passed < kMinPassed)) {
    return meanOfPassing(bounded(a), bounded(b));
  }
  const double share = (kMinPassed - a.passed) / (b.passed - a.passed);
  Passing middle = mixPassing(a, b, share);
  middle.passed = kMinPassed;
  return share * meanOfPassing(bounded(a), middle) + (1 - share) * meanOfPassing(middle, bounded(b));
}

Passing passingAt(const TransferPoint& below, const TransferPoint& above, double value) {
  const double range = above.value - below.value;
  const double share = range > 0 ? (value - below.value) / range : 0;
  return mixPassing({1 - below.opacity, below.color}, {1 - above.opacity, above.color}, share);
}

}  // namespace

glm::dvec4 transferIntegral(const TransferFunction& transfer, double first, double last) {
  const auto& points = transfer.points();
  glm::dvec4 sum(0);
  // The points before which and behind which a part lies; the outermost parts have one.
  auto next = std::ranges::upper_bound(points, first, {}, &TransferPoint::value);
  for (double from = first; from < last; ++next) {
    const TransferPoint& above = next == points.end() ? points.back() : *next;
    const TransferPoint& below = next == points.begin() ? points.front() : *(next - 1);
    const double to = next == points.end() ? last : std::min(last, above.value);
    if (to > from) {
      sum += (to - from) * meanBetween(passingAt(below, above, from), passingAt(below, above, to));
      from = to;
    }
  }
  return sum / transfer.opacityLength();
}

}  // namespace ocelli
