#include "display_sim/viewer/moving_pictures.h"

#include <vector>

namespace ocelli {

size_t movingPictureSize(std::span<const double> secondsOfSizes, double seconds) {
  constexpr double kHardlyLonger = 1.3;
  constexpr double kShareOfNext = 0.25;  // of an image half as wide, where that is not known
  std::vector<double> likely;
  for (const double known : secondsOfSizes) {
    likely.push_back(known > 0 ? known : likely.empty() ? 0 : likely.back() * kShareOfNext);
    if (likely.back() <= seconds) {
      return likely.size() - 1;
    }
  }
  const double fastest = *std::min_element(likely.begin(), likely.end());
  const auto found =
      std::find_if(likely.begin(), likely.end(), [&](double each) { return each <= kHardlyLonger * fastest; });
  return static_cast<size_t>(found - likely.begin());
}

}  // namespace ocelli
