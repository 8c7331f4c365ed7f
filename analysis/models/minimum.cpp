#include "analysis/models/minimum.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <nlopt.hpp>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Less curvature than this share of the largest counts as 0.
constexpr double kFlat = 1e-6;
/// A Newton step is cut to this length, in the units of the first step.
constexpr double kLongestNewtonStep = 1;
/// More negative curvature than this share is that of a saddle, not of rounding.
constexpr double kSaddle = 1e-3;
constexpr int kNewtonSteps = 10;
/// Where the search starts again, as factors of where it started.
constexpr std::array<double, 3> kRestarts = {0.3, 3, 0.05};
/// In place of a value that is not finite.
constexpr double kWorstValue = 1e300;

class Search {
 public:
  Search(const Objective& objective, const MinimumSearch& search) : objective_(objective), search_(search) {}

  Minimum from(const VectorXd& start) {
    Minimum minimum;
    minimum.point = nearMinimum([this](const VectorXd& point) { return at(point); }, start, search_);
    minimum.value = at(minimum.point);
    minimum.gradient = gradientAt(minimum.point);
    minimum.hessian = hessianAt(minimum);
    refine(minimum);
    minimum.evaluations = evaluations_;
    return minimum;
  }

 private:
  double at(const VectorXd& point) {
    ++evaluations_;
    const double value = objective_(point);
    return std::isfinite(value) ? value : kWorstValue;
  }

  double shifted(const VectorXd& point, Index index, double by) {
    VectorXd other = point;
    other[index] += by;
    return at(other);
  }

  double shifted(const VectorXd& point, Index first, Index second, double by) {
    VectorXd other = point;
    other[first] += by;
    other[second] += by;
    return at(other);
  }

  VectorXd gradientAt(const VectorXd& point) {
    const double h = search_.gradientStep;
    VectorXd gradient(point.size());
    for (Index i = 0; i < point.size(); ++i) {
      gradient[i] = (shifted(point, i, h) - shifted(point, i, -h)) / (2 * h);
    }
    return gradient;
  }

  MatrixXd hessianAt(const Minimum& minimum) {
    const Index size = minimum.point.size();
    const double h = search_.hessianStep;
    VectorXd along(size);
    MatrixXd hessian(size, size);
    for (Index i = 0; i < size; ++i) {
      along[i] = shifted(minimum.point, i, h) + shifted(minimum.point, i, -h) - 2 * minimum.value;
      hessian(i, i) = along[i] / (h * h);
      for (Index j = 0; j < i; ++j) {
        const double both = shifted(minimum.point, i, j, h) + shifted(minimum.point, i, j, -h) - 2 * minimum.value;
        hessian(i, j) = hessian(j, i) = (both - along[i] - along[j]) / (2 * h * h);
      }
    }
    return hessian;
  }

  /// Newton steps with the Hessian at hand, which is found again where they lead far.
  void refine(Minimum& minimum) {
    double moved = 0;
    for (int count = 0;; ++count) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(minimum.hessian);
      const VectorXd& curvatures = eigen.eigenvalues();
      const double largest = std::max(1.0, curvatures.cwiseAbs().maxCoeff());
      const VectorXd slopes = eigen.eigenvectors().transpose() * minimum.gradient;
      VectorXd step = VectorXd::Zero(slopes.size());
      minimum.expectedDecrease = 0;
      for (Index i = 0; i < slopes.size(); ++i) {
        const double curvature = std::abs(curvatures[i]);
        if (curvature > kFlat * largest) {
          step[i] = -slopes[i] / curvature;
          minimum.expectedDecrease += slopes[i] * slopes[i] / (2 * curvature);
        } else {
          // A slope without an end in sight is no minimum either.
          minimum.expectedDecrease += std::abs(slopes[i]) * search_.gradientStep;
        }
      }
      const bool goOn = minimum.expectedDecrease > search_.wantedDecrease && count < kNewtonSteps &&
                        move(minimum, eigen.eigenvectors() * step, moved);
      if (goOn) {
        minimum.gradient = gradientAt(minimum.point);
      } else if (moved > search_.hessianReach) {
        minimum.hessian = hessianAt(minimum);
        moved = 0;
      } else {
        judge(minimum, curvatures[0] < -kSaddle * largest);
        return;
      }
    }
  }

  /// False where the value does not fall.
  bool move(Minimum& minimum, VectorXd step, double& moved) {
    const double length = step.norm();
    if (length > kLongestNewtonStep * search_.firstStep) {
      step *= kLongestNewtonStep * search_.firstStep / length;
    }
    for (int halving = 0; halving < 6; ++halving, step /= 2) {
      const VectorXd next = minimum.point + step;
      const double value = at(next);
      if (value < minimum.value) {
        minimum.point = next;
        minimum.value = value;
        moved += step.norm();
        return true;
      }
    }
    return false;
  }

  void judge(Minimum& minimum, bool falls) const {
    if (minimum.value >= kWorstValue) {
      minimum.reason = "the deviance is not a finite number";
    } else if (falls) {
      minimum.reason = "the search ended at a saddle of the deviance";
    } else if (minimum.expectedDecrease > search_.allowedDecrease) {
      minimum.reason = fmt::format("the deviance could still fall by {:.2g}", minimum.expectedDecrease);
    } else if (evaluations_ >= search_.maxEvaluations) {
      minimum.reason = fmt::format("the search took more than {} evaluations", search_.maxEvaluations);
    } else {
      minimum.converged = true;
    }
  }

  const Objective& objective_;
  const MinimumSearch& search_;
  int evaluations_ = 0;
};

}  // namespace

VectorXd nearMinimum(const Objective& objective, const VectorXd& start, const MinimumSearch& search) {
  const auto size = static_cast<unsigned>(start.size());
  // BOBYQA needs two dimensions.
  nlopt::opt optimizer(size == 1 ? nlopt::LN_NELDERMEAD : nlopt::LN_BOBYQA, size);
  struct Call {
    const Objective& objective;
    Index size;
  } call{objective, start.size()};
  optimizer.set_min_objective(
      [](unsigned, const double* x, double*, void* data) {
        const auto* self = static_cast<Call*>(data);
        const double value = self->objective(Eigen::Map<const VectorXd>(x, self->size));
        return std::isfinite(value) ? value : kWorstValue;
      },
      &call);
  optimizer.set_initial_step(search.firstStep);
  optimizer.set_xtol_abs(search.lastStep);
  optimizer.set_maxeval(search.maxEvaluations);
  std::vector<double> point(start.data(), start.data() + start.size());
  double value = 0;
  try {
    optimizer.optimize(point, value);
  } catch (const nlopt::roundoff_limited&) {
    // As near as it comes.
  }
  return Eigen::Map<const VectorXd>(point.data(), start.size());
}

Minimum findMinimum(const Objective& objective, const VectorXd& start, const MinimumSearch& search) {
  Minimum best = Search(objective, search).from(start);
  for (const double factor : kRestarts) {
    if (best.converged) {
      break;
    }
    Minimum other = Search(objective, search).from(start * factor);
    other.evaluations += best.evaluations;
    const bool better = other.converged ? other.value <= best.value + search.allowedDecrease : other.value < best.value;
    if (better) {
      best = std::move(other);
    } else {
      best.evaluations = other.evaluations;
    }
  }
  return best;
}

MatrixXd covarianceOfMinimum(const MatrixXd& hessian) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(hessian);
  VectorXd inverse = eigen.eigenvalues();
  const double flat = kFlat * std::max(1.0, inverse.cwiseAbs().maxCoeff());
  for (double& each : inverse) {
    each = each > flat ? 2 / each : 0;
  }
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace ocelli
