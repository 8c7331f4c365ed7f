#include "analysis/inference/censored_difference.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "analysis/base/normal_tail.h"

namespace ocelli {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMaxIterations = 50;
/// Of the gain that a Newton step still promises.
constexpr double kRootConverged = 1e-12;
/// A variance below this share of the mean square is rounding.
constexpr double kNoSpread = 1e-12;

/// In the means over the standard deviation and the inverse of that, in which the log likelihood is concave (Olsen
/// 1978).
struct Likelihood {
  double value = 0;
  Vector3d slope = Vector3d::Zero();
  Matrix3d curvature = Matrix3d::Zero();  ///< less the second derivatives
};

void addGroup(const CensoredSums& group, int index, const Vector3d& at, Likelihood& likelihood) {
  const double mean = at[index];
  const double inverse = at[2];
  likelihood.value +=
      group.count * std::log(inverse) -
      (inverse * inverse * group.squares - 2 * inverse * mean * group.sum + group.count * mean * mean) / 2;
  likelihood.slope[index] += inverse * group.sum - group.count * mean;
  likelihood.slope[2] += group.count / inverse - inverse * group.squares + mean * group.sum;
  likelihood.curvature(index, index) += group.count;
  likelihood.curvature(index, 2) -= group.sum;
  likelihood.curvature(2, 2) += group.count / (inverse * inverse) + group.squares;
  for (const auto& [value, count] : group.above) {
    const double z = inverse * value - mean;
    const double hazard = normalHazard(z);
    const double bend = count * hazard * (hazard - z);
    likelihood.value += count * logNormalTail(z);
    likelihood.slope[index] += count * hazard;
    likelihood.slope[2] -= count * hazard * value;
    likelihood.curvature(index, index) += bend;
    likelihood.curvature(index, 2) -= bend * value;
    likelihood.curvature(2, 2) += bend * value * value;
  }
}

Likelihood likelihoodAt(const CensoredSums& first, const CensoredSums& second, const Vector3d& at) {
  Likelihood likelihood;
  if (!(at[2] > 0)) {
    likelihood.value = -std::numeric_limits<double>::infinity();
    return likelihood;
  }
  addGroup(first, 0, at, likelihood);
  addGroup(second, 1, at, likelihood);
  likelihood.curvature(2, 0) = likelihood.curvature(0, 2);
  likelihood.curvature(2, 1) = likelihood.curvature(1, 2);
  return likelihood;
}

}  // namespace

void CensoredSums::add(double value, bool censored) {
  if (censored) {
    above[value] += 1;
  } else {
    count += 1;
    sum += value;
    squares += value * value;
  }
}

std::optional<double> censoredMeanDifference(const CensoredSums& first, const CensoredSums& second) {
  if (first.count == 0 || second.count == 0) {
    return std::nullopt;
  }
  const double within =
      first.squares - first.sum * first.sum / first.count + second.squares - second.sum * second.sum / second.count;
  if (!(within > kNoSpread * (first.squares + second.squares))) {
    return std::nullopt;
  }
  const double inverse = std::sqrt((first.count + second.count) / within);
  Vector3d at(inverse * first.sum / first.count, inverse * second.sum / second.count, inverse);
  Likelihood here = likelihoodAt(first, second, at);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    Vector3d step = here.curvature.ldlt().solve(here.slope);
    if (!(step.dot(here.slope) > kRootConverged * (1 + std::abs(here.value)))) {
      return (at[1] - at[0]) / at[2];
    }
    Likelihood next = likelihoodAt(first, second, at + step);
    for (int halving = 0; halving < 30 && !(next.value > here.value); ++halving) {
      step /= 2;
      next = likelihoodAt(first, second, at + step);
    }
    at += step;
    here = next;
  }
  return std::nullopt;
}

}  // namespace ocelli
