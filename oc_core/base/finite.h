// Whether coordinates are numbers at all.
#pragma once

#include <cmath>

namespace ocelli {

/// `p` has x, y and z.
template <class Vector>
bool isFinite(const Vector& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace ocelli
