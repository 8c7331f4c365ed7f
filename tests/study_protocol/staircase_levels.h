// The levels that tests of staircases choose from.
#pragma once

#include <cmath>
#include <vector>

namespace ocelli {

/// 16 levels from 0.02 to 0.64 by equal factors.
inline std::vector<double> staircaseLevels() {
  std::vector<double> all;
  for (int i = 0; i < 16; ++i) {
    all.push_back(0.02 * std::pow(2, i / 3.0));
  }
  return all;
}

}  // namespace ocelli
