#include "oc_core/remote_measure/rate_curve.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

std::optional<double> bytesAtFlip(std::vector<RatePoint> curve, double flip) {
  std::sort(curve.begin(), curve.end(), [](const RatePoint& a, const RatePoint& b) { return a.bytes < b.bytes; });
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    const RatePoint& worse = curve[i];
    const RatePoint& better = curve[i + 1];
    if (!(flip <= worse.flip && flip >= better.flip && better.flip > 0)) {
      continue;
    }
    if (worse.flip == better.flip) {
      return worse.bytes;
    }
    const double t = std::log(flip / worse.flip) / std::log(better.flip / worse.flip);
    return worse.bytes * std::pow(better.bytes / worse.bytes, t);
  }
  return std::nullopt;
}

}  // namespace ocelli
