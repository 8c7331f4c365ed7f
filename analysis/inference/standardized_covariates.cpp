#include "analysis/inference/standardized_covariates.h"

#include <fmt/format.h>

#include <cmath>

namespace ocelli {
namespace {

/// Of the smallest eigenvalue to the largest, of a correlation matrix.
constexpr double kDependent = 1e-10;
/// Of an information to what it is with no effects.
constexpr double kFlat = 1e-6;

}  // namespace

StandardizedCovariates::StandardizedCovariates(const std::vector<Covariate>& covariates, size_t rows,
                                               const char* function)
    : values(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(covariates.size())),
      mean(Eigen::VectorXd::Zero(values.cols())),
      scale(Eigen::VectorXd::Ones(values.cols())) {
  checkCovariates(covariates, rows, function);
  if (rows == 0) {
    problem = "there are no trials";
    return;
  }
  if (covariates.empty()) {
    problem = "there is no covariate";
    return;
  }
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    const Covariate& covariate = covariates[static_cast<size_t>(j)];
    names.push_back(covariate.name);
    const Eigen::Map<const Eigen::VectorXd> raw(covariate.values.data(), values.rows());
    mean[j] = raw.mean();
    const double deviation = std::sqrt((raw.array() - mean[j]).square().mean());
    if (!(deviation > 1e-12 * std::abs(mean[j]))) {
      problem = fmt::format("'{}' is the same in all trials", covariate.name);
      return;
    }
    scale[j] = deviation;
    values.col(j) = (raw.array() - mean[j]) / deviation;
  }
}

std::string StandardizedCovariates::whyNotIndependent(const Eigen::MatrixXd& information) const {
  for (Eigen::Index j = 0; j < information.rows(); ++j) {
    if (!(information(j, j) > kDependent)) {
      return fmt::format("'{}' does not vary among trials that can be compared", names[static_cast<size_t>(j)]);
    }
  }
  const Eigen::VectorXd root = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd correlation = root.asDiagonal() * information * root.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
  if (solver.eigenvalues().minCoeff() > kDependent) {
    return {};
  }
  Eigen::Index most = 0;
  solver.eigenvectors().col(0).cwiseAbs().maxCoeff(&most);
  return fmt::format("'{}' follows from the other covariates", names[static_cast<size_t>(most)]);
}

Eigen::MatrixXd sandwich(const Eigen::MatrixXd& scoreResiduals, const Eigen::MatrixXd& model,
                         const DenseLabels& clusters) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(clusters.count), scoreResiduals.cols());
  for (size_t i = 0; i < clusters.of.size(); ++i) {
    sums.row(static_cast<Eigen::Index>(clusters.of[i])) += scoreResiduals.row(static_cast<Eigen::Index>(i));
  }
  const Eigen::MatrixXd influence = sums * model;
  return influence.transpose() * influence;
}

Eigen::MatrixXd withCrossed(const Eigen::MatrixXd& byFirst, const Eigen::MatrixXd& bySecond,
                            const Eigen::MatrixXd& byBoth) {
  if (byFirst.llt().info() != Eigen::Success) {
    return byFirst;
  }
  // The positive part, as crossed_clusters.h has it, in units of what is by the first: so in any units of the columns.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> added(bySecond - byBoth, byFirst);
  const Eigen::MatrixXd directions = byFirst * added.eigenvectors();
  return byFirst + directions * added.eigenvalues().cwiseMax(0).asDiagonal() * directions.transpose();
}

Eigen::MatrixXd sandwich(const Eigen::MatrixXd& scoreResiduals, const Eigen::MatrixXd& model,
                         const CrossedClusters& clusters) {
  const Eigen::MatrixXd byFirst = sandwich(scoreResiduals, model, clusters.first);
  return clusters.second.count == 0 ? byFirst
                                    : withCrossed(byFirst, sandwich(scoreResiduals, model, clusters.second),
                                                  sandwich(scoreResiduals, model, clusters.both));
}

std::vector<std::vector<double>> rowsOf(const Eigen::MatrixXd& matrix) {
  std::vector<std::vector<double>> rows(static_cast<size_t>(matrix.rows()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      rows[static_cast<size_t>(i)].push_back(matrix(i, j));
    }
  }
  return rows;
}

std::optional<size_t> flatDirection(const Eigen::MatrixXd& information, const Eigen::MatrixXd& reference) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(information, reference);
  if (solver.eigenvalues()[0] > kFlat) {
    return std::nullopt;
  }
  Eigen::Index most = 0;
  solver.eigenvectors().col(0).cwiseAbs().maxCoeff(&most);
  return static_cast<size_t>(most);
}

std::string fewClusters(const CrossedClusters& clusters, size_t coefficients) {
  const bool fewCases = clusters.second.count > 0 && clusters.second.count < clusters.first.count;
  const size_t count = fewCases ? clusters.second.count : clusters.first.count;
  return fmt::format("{} {}{} {} too few for robust errors of {} coefficient{}", count, fewCases ? "case" : "subject",
                     count == 1 ? "" : "s", count == 1 ? "is" : "are", coefficients, coefficients == 1 ? "" : "s");
}

}  // namespace ocelli
