#include "analysis/models/laplace_fit.h"

#include <cmath>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double columnLength(const Design& design) {
  return std::sqrt(static_cast<double>(design.rows()));
}

/// Coefficients of whitened coordinates.
MatrixXd unitsOf(const Design& design, const LaplaceIntegral& integral, const ResponseUnits& units) {
  const double length = units.scale * columnLength(design);
  return design.triangle.triangularView<Eigen::Upper>().solve(length * integral.units());
}

}  // namespace

MatrixXd laplaceColumns(const Design& design) {
  return columnLength(design) * design.basis;
}

MinimumSearch laplaceSearch() {
  MinimumSearch search;
  search.firstStep = 0.1;
  search.lastStep = 5e-3;
  search.gradientStep = 5e-4;
  search.hessianStep = 1e-2;
  search.hessianReach = 1e-3;
  return search;
}

RestrictedOptimum restrictedOptimum(LaplaceIntegral& integral, const RandomStructure& structure, const VectorXd& start,
                                    const MinimumSearch& search) {
  RestrictedOptimum optimum;
  const Objective restricted = [&](const VectorXd& variances) { return integral.restrictedAt(variances); };
  Minimum variances = findMinimum(restricted, start, search);
  settleAtBoundary(structure, restricted, variances);
  optimum.variances = variances.point;
  optimum.deviance = restricted(optimum.variances);
  optimum.varianceCovariance = covarianceOfMinimum(variances.hessian);

  integral.whiten(optimum.variances);
  const Objective deviance = [&](const VectorXd& coordinates) { return integral.at(optimum.variances, coordinates); };
  const Minimum fixed = findMinimum(deviance, VectorXd::Zero(integral.origin().size()), laplaceSearch());
  optimum.covariance = covarianceOfMinimum(fixed.hessian);
  optimum.minimum = fixed.converged ? variances : fixed;
  optimum.minimum.evaluations = variances.evaluations + fixed.evaluations;
  optimum.minimum.point.resize(optimum.variances.size() + fixed.point.size());
  optimum.minimum.point << optimum.variances, fixed.point;

  for (Index i = 0; i < optimum.variances.size(); ++i) {
    VectorXd shifted = optimum.variances;
    shifted[i] += search.hessianStep;
    MatrixXd difference = integral.covarianceAt(shifted);
    shifted[i] -= 2 * search.hessianStep;
    difference -= integral.covarianceAt(shifted);
    optimum.covarianceGradients.emplace_back(difference / (2 * search.hessianStep));
  }
  return optimum;
}

void describeLaplaceFit(const Design& design, const RandomStructure& structure, const ResponseFamily& family,
                        LaplaceIntegral& integral, const Minimum& minimum, const MatrixXd& covariance,
                        const ResponseUnits& units, MixedModelFit& fit) {
  const Index fixedCount = design.fixed.cols();
  const VectorXd variances = minimum.point.head(minimum.point.size() - fixedCount);
  const VectorXd coordinates = minimum.point.tail(fixedCount);
  fit.deviance = integral.at(variances, coordinates);
  fit.parameters = static_cast<int>(minimum.point.size());
  const double deviation = units.scale * family.scale();
  describeFit(design, structure, minimum, variances.head(structure.thetaSize()), units.scale * integral.randomEffects(),
              deviation * deviation, fit);
  VectorXd inBasis = units.scale * columnLength(design) * (integral.origin() + integral.units() * coordinates);
  if (units.leastSquares.size() > 0) {
    inBasis += units.leastSquares;
  }
  fit.coefficients = design.triangle.triangularView<Eigen::Upper>().solve(inBasis);
  const MatrixXd perCoordinate = unitsOf(design, integral, units);
  fit.covariance = perCoordinate * covariance * perCoordinate.transpose();
  fit.standardErrors = fit.covariance.diagonal().cwiseSqrt();
}

void addRestricted(const Design& design, const LaplaceIntegral& integral, const RestrictedOptimum& optimum,
                   const ResponseUnits& units, MixedModelFit& fit) {
  fit.restricted = true;
  // In the units of the coefficients.
  const Index fixedCount = design.fixed.cols();
  fit.deviance = optimum.deviance + 2 * design.triangle.diagonal().array().abs().log().sum() -
                 2 * static_cast<double>(fixedCount) * std::log(units.scale * columnLength(design));
  fit.varianceParameterCovariance = optimum.varianceCovariance;
  const MatrixXd perCoordinate = unitsOf(design, integral, units);
  for (const MatrixXd& gradient : optimum.covarianceGradients) {
    fit.covarianceGradients.push_back(perCoordinate * gradient * perCoordinate.transpose());
  }
}

}  // namespace ocelli
