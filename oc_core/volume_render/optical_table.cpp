#include "oc_core/volume_render/optical_table.h"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "oc_core/volume/transfer_integral.h"

namespace ocelli {
namespace {

/// Entries before the first and after the last value of interest, which are as those: what lies beyond is too.
constexpr int kMargin = 2;

/// Where the transfer function changes among the values of a range.
ValueRange rangeOfInterest(const TransferFunction& transfer, const ValueRange& range) {
  const double first = transfer.points().front().value;
  const double last = transfer.points().back().value;
  const double least = std::max(first, range.least);
  const double greatest = std::min(last, range.greatest);
  if (least < greatest) {
    return {least, greatest};
  }
  // One value, or a step: some width around it.
  const double center = range.least > last ? last : least;
  const double width = std::max({1e-4 * (range.greatest - range.least), 1e-6 * std::abs(center), 1e-12});
  return {center - width, center + width};
}

/// The mean from half an entry before a value to half an entry after it: sums of these keep all of the integral.
glm::dvec4 meanAround(const TransferFunction& transfer, double value, double distance) {
  return transferIntegral(transfer, value - distance / 2, value + distance / 2) / distance;
}

}  // namespace

OpticalTable::OpticalTable(const TransferFunction& transfer, const ValueRange& range)
    : entries_(kEntries), visibleBefore_(kEntries + 1) {
  const ValueRange interest = rangeOfInterest(transfer, range);
  const double distance = (interest.greatest - interest.least) / (kEntries - 1 - 2 * kMargin);
  firstValue_ = interest.least - kMargin * distance;
  entriesByValue_ = 1 / distance;
  glm::dvec4 integral(0);
  glm::dvec4 next = meanAround(transfer, firstValue_, distance);
  for (int i = 0; i < kEntries; ++i) {
    Entry& entry = entries_[static_cast<size_t>(i)];
    const glm::dvec4 at = next;
    next = i + 1 < kEntries ? meanAround(transfer, firstValue_ + (i + 1) * distance, distance) : at;
    for (int c = 0; c < 4; ++c) {
      const auto channel = static_cast<size_t>(c);
      entry.integral[channel] = static_cast<float>(integral[c]);
      entry.rest[channel] = static_cast<float>(integral[c] - static_cast<double>(entry.integral[channel]));
      entry.at[channel] = static_cast<float>(at[c]);
      entry.halfChange[channel] = static_cast<float>((next[c] - at[c]) / 2);
    }
    visibleBefore_[static_cast<size_t>(i) + 1] = visibleBefore_[static_cast<size_t>(i)] + (entry.at[0] > 0);
    integral += (at + next) / 2.0;
  }
}

bool OpticalTable::isEmpty(double least, double greatest) const {
  // One more to either side, for what is rounded.
  const double last = kEntries - 1;
  const double begin = std::clamp(std::floor((least - firstValue_) * entriesByValue_) - 1, 0.0, last);
  const double end = std::clamp(std::ceil((greatest - firstValue_) * entriesByValue_) + 1, 0.0, last) + 1;
  return visibleBefore_[static_cast<size_t>(end)] == visibleBefore_[static_cast<size_t>(begin)];
}

}  // namespace ocelli
