// How the samples of a general pinhole camera (GPC, chapter 5) spread between a region of detail and the image around
// it: the distortion along each line from the centre of the region (Equations 5.1 to 5.5).
//
// Distances from the centre are relative to the region's half extent: the inner edge is at r = 1, the outer edge of the
// transition at r = `outer`. The sample at distance r of the camera's image lies at distance f(r) of the pinhole's:
// r / zoom up to the inner edge, r from the outer edge on, and a polynomial f of the distance from the inner edge
// between the two. The sampling rate is 1 / f'(r): samples for each one of the pinhole.
//
//   linear     f(1) = 1 / zoom, f(outer) = outer; a constant rate, which jumps at both edges
//   quadratic  and f'(1) = 1 / zoom (Equation 5.2): no jump at the inner edge
//   cubic      and f'(outer) = 1 (Equation 5.5): none at either edge
//
// f is invertible where f' > 0 all along: isIncreasing(). With zoom >= 1 it always is, however narrow the transition.
// Below 1 the transition must be wide enough: linear zoom > 1 / outer, quadratic zoom > (outer + 1) / (2 outer), cubic
// where the least value of the quadratic f', at its vertex, is positive.
#pragma once

#include <array>
#include <span>

namespace ocelli {

/// One row of gpcSamplings(). The coefficients of f are those of (r - 1)^0 to (r - 1)^3.
struct GpcSampling {
  const char* name;
  const char* meaning;
  std::array<double, 4> (*coefficients)(double zoom, double outer);
};

/// Linear, quadratic, cubic.
std::span<const GpcSampling> gpcSamplings();
/// Nothing for a name that no row has.
const GpcSampling* findGpcSampling(const char* name);

class GpcProfile {
 public:
  /// `zoom` > 0, `outer` > 1.
  GpcProfile(const GpcSampling& sampling, double zoom, double outer);

  double outer() const { return outer_; }
  double zoom() const { return zoom_; }
  /// Of f within the transition: of (r - 1)^0 to (r - 1)^3.
  const std::array<double, 4>& coefficients() const { return c_; }
  bool isIncreasing() const { return leastSlope_ > 0; }

  /// f, for any r >= 0. Within the transition the polynomial itself.
  double sampled(double r) const {
    if (r <= 1) {
      return r / zoom_;
    }
    return r >= outer_ ? r : polynomial(r - 1);
  }
  /// f'. At an edge that of the transition.
  double slope(double r) const {
    if (r < 1 || r > outer_) {
      return r < 1 ? 1 / zoom_ : 1;
    }
    const double s = r - 1;
    return c_[1] + s * (2 * c_[2] + s * 3 * c_[3]);
  }
  /// r of a value of f. Up to a quadratic in closed form (Equation 5.3), of a cubic by Newton steps in a bracket.
  double inverse(double f) const;

  /// 1 / f' where f' is greatest: exactly, as f' has its extremes at the edges or at its vertex.
  double leastRate() const { return 1 / greatestSlope_; }
  /// 1 / f' where f' is least.
  double greatestRate() const { return 1 / leastSlope_; }
  /// The greatest |r - f(r)|: how far a sample moves, half extents.
  double longestShift() const { return longestShift_; }

 private:
  double polynomial(double s) const { return c_[0] + s * (c_[1] + s * (c_[2] + s * c_[3])); }
  double inverseOfCubic(double f) const;
  static constexpr int kTableSteps = 64;

  double zoom_;
  double outer_;
  std::array<double, 4> c_;
  double leastSlope_ = 0;
  double greatestSlope_ = 0;
  double longestShift_ = 0;
  std::array<double, kTableSteps + 1> table_{};  ///< of a cubic: inverses of equal steps of f, to begin from
};

/// The greatest least rate that any transition between these edges may have: that of the linear one. f grows by
/// outer - 1 / zoom over outer - 1, so its slope is somewhere as great as that mean.
double highestLeastRate(double zoom, double outer);

}  // namespace ocelli
