#include "oc_core/remote/server/slow_link.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

int64_t SlowLink::leavesAt(size_t bytes, int64_t readyAt) {
  const double seconds = settings_.bytesPerSecond > 0 ? static_cast<double>(bytes) / settings_.bytesPerSecond : 0.0;
  freeAt_ = std::max(freeAt_, readyAt) + std::llround(seconds * 1e9);
  return freeAt_ + std::llround(settings_.delayMilliseconds * 1e6);
}

}  // namespace ocelli
