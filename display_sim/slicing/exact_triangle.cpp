#include "display_sim/slicing/exact_triangle.h"

#include <algorithm>
#include <cmath>

namespace ocelli {

SweepVertex sweepVertex(const SweepGeometry& sweep, const glm::vec3& position) {
  // Single precision will do: the angle only proposes sectors, which clipping then confirms.
  return {sweepPoint(sweep, position), std::atan2(position.z, position.x) / sweep.stepRadians()};
}

SectorRange sectorsOf(const SweepVertex& a, const SweepVertex& b, const SweepVertex& c, int sectors) {
  const double half = sectors / 2;
  const auto stepsFrom = [&](double steps) {
    return steps > half ? steps - sectors : steps < -half ? steps + sectors : steps;
  };
  const double toB = stepsFrom(b.steps - a.steps);
  const double toC = stepsFrom(c.steps - a.steps);
  constexpr double kMargin = 1e-2;  // far above the rounding of the angles, in steps
  const double lo = a.steps + std::min({0.0, toB, toC}) - kMargin;
  const double hi = a.steps + std::max({0.0, toB, toC}) + kMargin;
  const auto onAxis = [](const SweepVertex& vertex) { return vertex.point.x == 0 && vertex.point.z == 0; };
  // Seen from the axis a triangle beside it spans less than half a turn, one that holds it at least that.
  if (hi - lo >= half || onAxis(a) || onAxis(b) || onAxis(c)) {
    return {0, sectors};
  }
  const int first = static_cast<int>(std::floor(lo + 0.5));
  const int last = static_cast<int>(std::floor(hi + 0.5));
  return {(first + sectors) % sectors, last - first + 1};
}

}  // namespace ocelli
