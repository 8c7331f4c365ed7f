#include "display_sim/volume_slicing/cell_share.h"

#include <algorithm>
#include <array>

namespace ocelli {
namespace {

/// An edge that reaches less than this share of the longest one counts as none: sums of cubes would lose their digits.
constexpr double kMinReach = 1e-3;

double positive(double x) {
  return std::max(x, 0.0);
}

}  // namespace

// The distance of a point of the block from the plane is a sum of three numbers, each spread evenly over [-reach,
// reach]: the share is how much of that sum's distribution lies above 0, a sum of cubes over the block's corners.
double shareOfBlock(double distance, const glm::dvec3& reaches) {
  std::array<double, 3> r{reaches.x, reaches.y, reaches.z};
  std::ranges::sort(r);
  const double sum = r[0] + r[1] + r[2];
  if (distance >= sum) {
    return 1;
  }
  if (distance <= -sum) {
    return 0;
  }
  const double d = distance;
  if (r[1] < kMinReach * r[2]) {
    return std::clamp(0.5 + d / (2 * r[2]), 0.0, 1.0);
  }
  double share = 0;
  if (r[0] < kMinReach * r[2]) {
    for (const double s1 : {-1.0, 1.0}) {
      for (const double s2 : {-1.0, 1.0}) {
        const double at = positive(d + s1 * r[1] + s2 * r[2]);
        share += s1 * s2 * at * at;
      }
    }
    return std::clamp(share / (8 * r[1] * r[2]), 0.0, 1.0);
  }
  for (const double s0 : {-1.0, 1.0}) {
    for (const double s1 : {-1.0, 1.0}) {
      for (const double s2 : {-1.0, 1.0}) {
        const double at = positive(d + s0 * r[0] + s1 * r[1] + s2 * r[2]);
        share += s0 * s1 * s2 * at * at * at;
      }
    }
  }
  return std::clamp(share / (48 * r[0] * r[1] * r[2]), 0.0, 1.0);
}

}  // namespace ocelli
