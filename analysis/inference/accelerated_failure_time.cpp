#include "analysis/inference/accelerated_failure_time.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/base/distributions.h"
#include "analysis/inference/cluster_jackknife.h"
#include "analysis/inference/standardized_covariates.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaximumIterations = 200;
/// Of the decrease that a Newton step still promises, in units of the log-likelihood.
constexpr double kConverged = 1e-18;
/// The largest step of log sigma, which runs away where there is no spread.
constexpr double kLargestStep = 1;
/// Sigma, in log seconds, below which the times are told exactly.
constexpr double kPerfect = 1e-6;
/// Of a robust variance in that of the model: below it stands rounding.
constexpr double kMinRobustShare = 1e-12;

struct LogLikelihood {
  double logLikelihood = 0;
  MatrixXd scores;  ///< a row a trial: of the coefficients, then of log sigma
  MatrixXd information;
};

/// At `theta`: coefficients of the columns of `x`, then log sigma.
LogLikelihood likelihoodAt(const std::vector<SurvivalTime>& times, const MatrixXd& x, const VectorXd& theta) {
  const Index p = x.cols();
  LogLikelihood value{0, MatrixXd::Zero(x.rows(), p + 1), MatrixXd::Zero(p + 1, p + 1)};
  const VectorXd fitted = x * theta.head(p);
  const double sigma = std::exp(theta[p]);
  for (Index i = 0; i < x.rows(); ++i) {
    const SurvivalTime& time = times[static_cast<size_t>(i)];
    const double logTime = std::log(time.seconds);
    const double z = (logTime - fitted[i]) / sigma;
    // Of the log-likelihood of z: minus its first derivative, and minus its second.
    double slope = z;
    double curvature = 1;
    if (time.observed) {
      value.logLikelihood += -theta[p] - z * z / 2 - std::log(2 * std::numbers::pi) / 2 - logTime;
    } else {
      slope = normalHazard(z);
      curvature = slope * (slope - z);
      value.logLikelihood += logNormalTail(z);
    }
    const VectorXd row = x.row(i).transpose();
    value.scores.row(i).head(p) = slope / sigma * row.transpose();
    value.scores(i, p) = z * slope - (time.observed ? 1 : 0);
    value.information.topLeftCorner(p, p) += curvature / (sigma * sigma) * row * row.transpose();
    value.information.col(p).head(p) += (slope + z * curvature) / sigma * row;
    value.information(p, p) += z * slope + z * z * curvature;
  }
  value.information.row(p).head(p) = value.information.col(p).head(p).transpose();
  return value;
}

/// Coefficients and log sigma of least squares, censored times taken as they are.
VectorXd startOf(const std::vector<SurvivalTime>& times, const MatrixXd& x) {
  VectorXd logTimes(x.rows());
  for (Index i = 0; i < x.rows(); ++i) {
    logTimes[i] = std::log(times[static_cast<size_t>(i)].seconds);
  }
  VectorXd theta(x.cols() + 1);
  theta.head(x.cols()) = x.colPivHouseholderQr().solve(logTimes);
  const VectorXd rest = logTimes - x * theta.head(x.cols());
  theta[x.cols()] = std::log(std::max(std::sqrt(rest.squaredNorm() / static_cast<double>(x.rows())), 1e-3));
  return theta;
}

struct Maximum {
  VectorXd theta;
  LogLikelihood value;
  int iterations = 0;
};

/// A step uphill: Newton's, or where the likelihood curves the wrong way, the one that fits if nothing were censored.
VectorXd stepFrom(const LogLikelihood& value, const VectorXd& score, const MatrixXd& informationOfObserved) {
  const Eigen::LDLT<MatrixXd> newton(value.information);
  if (newton.info() == Eigen::Success && newton.vectorD().minCoeff() > 1e-12 * newton.vectorD().maxCoeff()) {
    return newton.solve(score);
  }
  return informationOfObserved.ldlt().solve(score);
}

Estimable<Maximum> maximize(const SurvivalData& data, const MatrixXd& x, const std::vector<std::string>& names) {
  using Result = Estimable<Maximum>;
  Maximum maximum;
  maximum.theta = startOf(data.times, x);
  maximum.value = likelihoodAt(data.times, x, maximum.theta);
  const Index p = x.cols();
  MatrixXd observed = MatrixXd::Zero(p + 1, p + 1);  // the information if nothing were censored
  observed(p, p) = 2 * static_cast<double>(x.rows());
  for (maximum.iterations = 1; maximum.iterations <= kMaximumIterations; ++maximum.iterations) {
    const double sigma = std::exp(maximum.theta[p]);
    if (sigma < kPerfect) {
      return Result::impossible("the covariates tell the times exactly, so there is no spread to compare with");
    }
    observed.topLeftCorner(p, p) = x.transpose() * x / (sigma * sigma);
    if (const auto flat = flatDirection(maximum.value.information.topLeftCorner(p, p), observed.topLeftCorner(p, p))) {
      return Result::impossible(
          fmt::format("the likelihood grows without bound in '{}', as where one group has no event", names[*flat]));
    }
    const VectorXd score = maximum.value.scores.colwise().sum().transpose();
    const VectorXd step = stepFrom(maximum.value, score, observed);
    if (!(step.dot(score) > kConverged * (1 + std::abs(maximum.value.logLikelihood)))) {
      return maximum;
    }
    double length = std::min(1.0, kLargestStep / std::abs(step[p]));
    LogLikelihood next = likelihoodAt(data.times, x, maximum.theta + length * step);
    // Near the maximum the likelihood cannot tell steps apart any more.
    const double slack = 1e-13 * std::abs(maximum.value.logLikelihood);
    while (!(next.logLikelihood >= maximum.value.logLikelihood - slack) && length > 1e-9) {
      length /= 2;
      next = likelihoodAt(data.times, x, maximum.theta + length * step);
    }
    maximum.theta += length * step;
    maximum.value = next;
  }
  return Result::impossible(fmt::format("the fit did not converge in {} steps", kMaximumIterations));
}

/// The information in some trials is without what the spread has in common with the coefficients, which is nothing for
/// times that are not censored. What these trials have of it by chance would lead a single step astray.
TrialShares sharesOf(const std::vector<SurvivalTime>& times, const MatrixXd& x, const Maximum& maximum) {
  return {maximum.value.scores, maximum.value.information, [&](const std::vector<size_t>& trials) {
            std::vector<SurvivalTime> some;
            MatrixXd rows(static_cast<Index>(trials.size()), x.cols());
            for (size_t i = 0; i < trials.size(); ++i) {
              some.push_back(times[trials[i]]);
              rows.row(static_cast<Index>(i)) = x.row(static_cast<Index>(trials[i]));
            }
            MatrixXd information = likelihoodAt(some, rows, maximum.theta).information;
            information.row(x.cols()).head(x.cols()).setZero();
            information.col(x.cols()).head(x.cols()).setZero();
            return information;
          }};
}

/// Why there is no such fit, before it is tried; empty where there may be one.
std::string obstacle(const SurvivalData& data, const StandardizedCovariates& covariates) {
  if (!covariates.problem.empty() && !data.covariates.empty()) {
    return covariates.problem;
  }
  if (data.times.empty()) {
    return "there are no trials";
  }
  if (std::none_of(data.times.begin(), data.times.end(), [](const SurvivalTime& time) { return time.observed; })) {
    return fmt::format("none of {} trials ended by itself", data.times.size());
  }
  if (std::any_of(data.times.begin(), data.times.end(), [](const SurvivalTime& time) { return time.seconds == 0; })) {
    return "a trial took 0 s, which has no logarithm";
  }
  return data.covariates.empty() ? std::string()
                                 : covariates.whyNotIndependent(covariates.values.transpose() * covariates.values);
}

}  // namespace

Estimable<FailureTimeFit> fitLogNormal(const SurvivalData& data, double level) {
  checkSurvivalData(data, "fitLogNormal");
  requireArgument(data.strata.empty(), "a log-normal model has no strata", "fitLogNormal");
  const StandardizedCovariates covariates(data.covariates, data.times.size(), "fitLogNormal");
  if (const std::string reason = obstacle(data, covariates); !reason.empty()) {
    return Estimable<FailureTimeFit>::impossible(reason);
  }
  const Index p = covariates.values.cols();
  MatrixXd x(covariates.values.rows(), p + 1);
  x << VectorXd::Ones(x.rows()), covariates.values;
  std::vector<std::string> names = {"intercept"};
  names.insert(names.end(), covariates.names.begin(), covariates.names.end());
  const Estimable<Maximum> maximum = maximize(data, x, names);
  if (!maximum) {
    return Estimable<FailureTimeFit>::impossible(maximum.reason());
  }
  // Back from standardized covariates: raw = back * standardized.
  MatrixXd back = MatrixXd::Identity(p + 2, p + 2);
  for (Index j = 0; j < p; ++j) {
    back(j + 1, j + 1) = 1 / covariates.scale[j];
    back(0, j + 1) = -covariates.mean[j] / covariates.scale[j];
  }
  const VectorXd theta = back * maximum->theta;
  const MatrixXd standardizedModel = maximum->value.information.inverse();
  const MatrixXd model = back * standardizedModel * back.transpose();
  MatrixXd covariance = model;
  std::optional<JackknifeCovariance> jackknife;
  std::vector<bool> unknown(static_cast<size_t>(p) + 2, false);
  const CrossedClusters clusters = crossedClusters(data.clusters, data.items);
  if (clusters.first.count > 0) {
    if (clusters.degreesOfFreedom() < static_cast<double>(p) + 1) {
      return Estimable<FailureTimeFit>::impossible(fewClusters(clusters, static_cast<size_t>(p) + 1));
    }
    if (data.fewClusters) {
      jackknife = jackknifeCovariance(sharesOf(data.times, x, *maximum), clusters).mapped(back);
      const std::vector<bool> rest = restOnOneCluster(covariates.values, clusters);
      std::copy(rest.begin(), rest.end(), unknown.begin() + 1);
      // The intercept stands where all covariates are 0.
      unknown.front() = std::find(rest.begin(), rest.end(), true) != rest.end();
    }
    covariance = jackknife ? jackknife->covariance
                           : back * sandwich(maximum->value.scores, standardizedModel, clusters) * back.transpose();
    if (!((covariance.diagonal().array() > kMinRobustShare * model.diagonal().array()).all())) {
      return Estimable<FailureTimeFit>::impossible("all subjects are alike, so that robust errors would be 0");
    }
  }
  FailureTimeFit fit;
  fit.logLikelihood = maximum->value.logLikelihood;
  fit.iterations = maximum->iterations;
  fit.trials = data.times.size();
  fit.clusters = clusters.first.count;
  fit.events = static_cast<size_t>(
      std::count_if(data.times.begin(), data.times.end(), [](const SurvivalTime& time) { return time.observed; }));
  const auto estimate = [&](Index j) {
    const double error = unknown[static_cast<size_t>(j)] ? kNotKnown : std::sqrt(covariance(j, j));
    return waldEstimate(theta[j], error, level, jackknife ? jackknife->degreesOfFreedom(j, clusters) : kInfinite);
  };
  fit.intercept = estimate(0);
  fit.logSigma = estimate(p + 1);
  for (Index j = 1; j <= p; ++j) {
    fit.terms.push_back({names[static_cast<size_t>(j)], estimate(j), asRatio(estimate(j)), std::sqrt(model(j, j))});
  }
  fit.covariance = rowsOf(covariance);
  return fit;
}

}  // namespace ocelli
