#include "oc_core/constructor/split_depths.h"

#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {

SplitDepths::SplitDepths(size_t frames) : frames_(frames) {
  OC_CHECK(frames >= 1, "a mean is over one frame at least");
}

std::vector<SplitDepth> SplitDepths::next(std::span<const SplitDepth> depths) {
  std::map<std::string, double> frame;
  for (const SplitDepth& each : depths) {
    OC_CHECK(std::isfinite(each.depth), "depths are finite");
    OC_CHECK(frame.emplace(each.name, each.depth).second, "a frame names each split once");
  }
  last_.push_back(std::move(frame));
  if (last_.size() > frames_) {
    last_.pop_front();
  }
  std::vector<SplitDepth> means;
  for (const SplitDepth& each : depths) {
    means.push_back({each.name, depth(each.name)});
  }
  return means;
}

double SplitDepths::depth(const std::string& name) const {
  // Summed anew for each frame, so that rounding does not add up.
  double sum = 0;
  for (const auto& frame : last_) {
    const auto found = frame.find(name);
    sum += found == frame.end() ? 0 : found->second;
  }
  return last_.empty() ? 0 : sum / static_cast<double>(last_.size());
}

void SplitDepths::clear() {
  last_.clear();
}

}  // namespace ocelli
