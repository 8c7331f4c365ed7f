#include "analysis/inference/cluster_jackknife.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/inference/standardized_covariates.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the information without a cluster in that with it: below it stands rounding.
constexpr double kMinInformationLeft = 1e-8;
/// Of a covariate in a direction.
constexpr double kNoPart = 1e-6;

std::vector<std::vector<size_t>> trialsOf(const DenseLabels& clusters) {
  std::vector<std::vector<size_t>> trials(clusters.count);
  for (size_t i = 0; i < clusters.of.size(); ++i) {
    trials[clusters.of[i]].push_back(i);
  }
  return trials;
}

class Jackknife {
 public:
  explicit Jackknife(const TrialShares& shares) : shares_(shares), root_(shares.information.llt().matrixL()) {}

  /// The sum over clusters of the outer products of what coefficients change by.
  MatrixXd squaresOfChanges(const DenseLabels& clusters) const {
    MatrixXd squares = MatrixXd::Zero(root_.rows(), root_.cols());
    for (const std::vector<size_t>& cluster : trialsOf(clusters)) {
      const VectorXd change = changeWithout(cluster);
      squares += change * change.transpose();
    }
    const auto count = static_cast<double>(clusters.count);
    return (count - 1) / count * squares;
  }

 private:
  /// A Newton step from the coefficients of all trials, in units in which the information is 1 in each direction. In
  /// directions that the others do not tell, there is no step.
  VectorXd changeWithout(const std::vector<size_t>& cluster) const {
    VectorXd score = VectorXd::Zero(root_.rows());
    for (const size_t trial : cluster) {
      score += shares_.scores.row(static_cast<Index>(trial)).transpose();
    }
    const auto lower = root_.triangularView<Eigen::Lower>();
    const MatrixXd half = lower.solve(shares_.informationIn(cluster));
    const MatrixXd share = lower.solve(half.transpose());
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver((share + share.transpose()) / 2);
    const VectorXd left = 1 - solver.eigenvalues().array();
    VectorXd step = solver.eigenvectors().transpose() * lower.solve(score);
    for (Index direction = 0; direction < step.size(); ++direction) {
      step[direction] = left[direction] > kMinInformationLeft ? step[direction] / left[direction] : 0;
    }
    return -root_.transpose().triangularView<Eigen::Upper>().solve(solver.eigenvectors() * step);
  }

  const TrialShares& shares_;
  MatrixXd root_;  ///< lower triangle, of the information
};

/// About their means, of the rows that `isKept` says.
MatrixXd squaresAboutMeans(const MatrixXd& covariates, const std::function<bool(Index)>& isKept) {
  VectorXd mean = VectorXd::Zero(covariates.cols());
  double count = 0;
  for (Index i = 0; i < covariates.rows(); ++i) {
    if (isKept(i)) {
      mean += covariates.row(i).transpose();
      ++count;
    }
  }
  mean /= std::max(1.0, count);
  MatrixXd squares = MatrixXd::Zero(covariates.cols(), covariates.cols());
  for (Index i = 0; i < covariates.rows(); ++i) {
    if (isKept(i)) {
      const VectorXd difference = covariates.row(i).transpose() - mean;
      squares += difference * difference.transpose();
    }
  }
  return squares;
}

}  // namespace

double JackknifeCovariance::degreesOfFreedom(Index coefficient, const CrossedClusters& clusters) const {
  const double ofFirst = static_cast<double>(clusters.first.count) - 1;
  const double sum = covariance(coefficient, coefficient);
  const double first = byFirst(coefficient, coefficient);
  if (clusters.second.count == 0 || !(sum > first)) {
    return std::max(ofFirst, clusters.degreesOfFreedom());
  }
  const double ofSecond = static_cast<double>(clusters.second.count) - 1;
  const double second = bySecond(coefficient, coefficient);
  return std::max(clusters.degreesOfFreedom(), sum * sum / (first * first / ofFirst + second * second / ofSecond));
}

JackknifeCovariance JackknifeCovariance::mapped(const MatrixXd& map) const {
  const auto of = [&](const MatrixXd& matrix) -> MatrixXd {
    return matrix.size() == 0 ? matrix : MatrixXd(map * matrix * map.transpose());
  };
  return {of(covariance), of(byFirst), of(bySecond)};
}

JackknifeCovariance jackknifeCovariance(const TrialShares& shares, const CrossedClusters& clusters) {
  const Jackknife jackknife(shares);
  JackknifeCovariance result;
  result.byFirst = jackknife.squaresOfChanges(clusters.first);
  result.covariance = result.byFirst;
  if (clusters.second.count > 0) {
    result.bySecond = jackknife.squaresOfChanges(clusters.second);
    result.covariance = withCrossed(result.byFirst, result.bySecond,
                                    sandwich(shares.scores, shares.information.inverse(), clusters.both));
  }
  return result;
}

std::vector<bool> restOnOneCluster(const MatrixXd& covariates, const CrossedClusters& clusters) {
  std::vector<bool> rest(static_cast<size_t>(covariates.cols()), false);
  const MatrixXd all = squaresAboutMeans(covariates, [](Index) { return true; });
  for (const DenseLabels* labels : {&clusters.first, &clusters.second}) {
    for (size_t cluster = 0; cluster < labels->count; ++cluster) {
      const MatrixXd others =
          squaresAboutMeans(covariates, [&](Index trial) { return labels->of[static_cast<size_t>(trial)] != cluster; });
      const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(others, all);
      for (Index direction = 0; direction < all.cols(); ++direction) {
        const VectorXd untold = solver.eigenvectors().col(direction);
        for (Index j = 0; j < all.cols() && solver.eigenvalues()[direction] < kMinInformationLeft; ++j) {
          rest[static_cast<size_t>(j)] = rest[static_cast<size_t>(j)] || std::abs(untold[j]) > kNoPart * untold.norm();
        }
      }
    }
  }
  return rest;
}

}  // namespace ocelli
