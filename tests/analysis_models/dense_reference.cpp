#include "tests/analysis_models/dense_reference.h"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double logDeterminant(const MatrixXd& matrix) {
  return matrix.fullPivLu().matrixLU().diagonal().array().abs().log().sum();
}

double logLikelihood(const BinomialResponse& response, Index row, double predictor) {
  const double n = response.trials[row];
  const double k = response.successes[row];
  return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - k * std::log1p(std::exp(-predictor)) -
         (n - k) * std::log1p(std::exp(predictor));
}

/// `logDensity`: of a row at its predictor. One term of intercepts, of the standard deviation `theta`.
template <class LogDensity>
double gridDeviance(const Design& design, double theta, const VectorXd& coefficients, const LogDensity& logDensity) {
  const RandomTerm& term = design.random[0];
  const VectorXd fixed = design.fixed * coefficients;
  const double step = 0.001;
  double deviance = 0;
  for (size_t level = 0; level < term.levels.size(); ++level) {
    double integral = 0;
    for (int i = -9000; i <= 9000; ++i) {
      const double u = step * i;
      double sum = -u * u / 2;
      for (Index row = 0; row < fixed.size(); ++row) {
        if (term.levelOfRow[static_cast<size_t>(row)] == static_cast<int>(level)) {
          sum += logDensity(row, fixed[row] + theta * u);
        }
      }
      integral += step * std::exp(sum) / std::sqrt(2 * std::numbers::pi);
    }
    deviance -= 2 * std::log(integral);
  }
  return deviance;
}

}  // namespace

MatrixXd denseRandomColumns(const std::vector<RandomTerm>& terms, const VectorXd& theta) {
  MatrixXd columns;
  Index next = 0;
  for (const RandomTerm& term : terms) {
    const Index effects = term.columns.cols();
    MatrixXd lower = MatrixXd::Zero(effects, effects);
    for (Index column = 0; column < effects; ++column) {
      for (Index row = column; row < (term.correlated ? effects : column + 1); ++row) {
        lower(row, column) = theta[next++];
      }
    }
    const Index before = columns.cols();
    const auto levels = static_cast<Index>(term.levels.size());
    columns.conservativeResize(term.columns.rows(), before + levels * effects);
    columns.rightCols(levels * effects).setZero();
    for (Index row = 0; row < term.columns.rows(); ++row) {
      const Index level = term.levelOfRow[static_cast<size_t>(row)];
      columns.block(row, before + level * effects, 1, effects) = term.columns.row(row) * lower;
    }
  }
  return columns;
}

double denseGaussianDeviance(const Design& design, const VectorXd& response, const VectorXd& theta, bool restricted) {
  const MatrixXd z = denseRandomColumns(design.random, theta);
  const MatrixXd& x = design.fixed;
  const MatrixXd v = z * z.transpose() + MatrixXd::Identity(x.rows(), x.rows());
  const MatrixXd precision = v.inverse();
  const MatrixXd information = x.transpose() * precision * x;
  const VectorXd beta = information.inverse() * (x.transpose() * precision * response);
  const VectorXd rest = response - x * beta;
  const auto freedom = static_cast<double>(x.rows() - (restricted ? x.cols() : 0));
  const double variance = rest.dot(precision * rest) / freedom;
  return logDeterminant(v) + freedom * std::log(2 * std::numbers::pi * variance) + freedom +
         (restricted ? logDeterminant(information) : 0);
}

double gridBinomialDeviance(const Design& design, const BinomialResponse& response, double theta,
                            const VectorXd& coefficients) {
  return gridDeviance(design, theta, coefficients,
                      [&](Index row, double predictor) { return logLikelihood(response, row, predictor); });
}

double gridCensoredDeviance(const Design& design, const CensoredResponse& response, double theta,
                            double residualDeviation, const VectorXd& coefficients) {
  return gridDeviance(design, theta * residualDeviation, coefficients, [&](Index row, double predictor) {
    const double z = (response.values[row] - predictor) / residualDeviation;
    return response.censored[static_cast<size_t>(row)]
               ? std::log(std::erfc(z / std::numbers::sqrt2) / 2)
               : -z * z / 2 - std::log(residualDeviation) - std::log(2 * std::numbers::pi) / 2;
  });
}

double denseLaplaceDeviance(const Design& design, const BinomialResponse& response, const VectorXd& theta,
                            const VectorXd& coefficients) {
  const MatrixXd z = denseRandomColumns(design.random, theta);
  const VectorXd fixed = design.fixed * coefficients;
  VectorXd u = VectorXd::Zero(z.cols());
  MatrixXd hessian;
  // Short steps: whole ones may lead away.
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Eigen::ArrayXd p = 1 / (1 + (-(fixed + z * u).array()).exp());
    const VectorXd weights = response.trials.array() * p * (1 - p);
    hessian = z.transpose() * weights.asDiagonal() * z + MatrixXd::Identity(z.cols(), z.cols());
    const VectorXd gradient = z.transpose() * (response.successes.array() - response.trials.array() * p).matrix() - u;
    u += 0.3 * hessian.inverse() * gradient;
  }
  const VectorXd predictor = fixed + z * u;
  double deviance = u.squaredNorm() + logDeterminant(hessian);
  for (Index row = 0; row < predictor.size(); ++row) {
    deviance -= 2 * logLikelihood(response, row, predictor[row]);
  }
  return deviance;
}

}  // namespace ocelli
