#include "analysis/plot/style.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

double pointOpacity(size_t points) {
  return std::clamp(4.5 / std::sqrt(static_cast<double>(std::max<size_t>(points, 1))), 0.18, 0.6);
}

}  // namespace ocelli
