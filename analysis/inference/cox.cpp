#include "analysis/inference/cox.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "analysis/inference/cluster_jackknife.h"
#include "analysis/inference/kaplan_meier.h"
#include "analysis/inference/standardized_covariates.h"
#include "analysis/inference/wald.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kCoxIterations = 100;
/// Of the decrease that a Newton step still promises, in units of the log-likelihood.
constexpr double kCoxConverged = 1e-18;
/// Of a robust variance in that of the model: below it stands rounding.
constexpr double kCoxLeastShare = 1e-12;

/// Efron's step `step` of `deaths` at a tied time: those who died weigh 1 - step / deaths any more.
struct RiskStep {
  size_t moment = 0;  ///< index of the time, which counts down through the strata
  double seconds = 0;
  int step = 0;
  int deaths = 0;
  double mass = 0;      ///< sum of exp(eta) at risk
  VectorXd mean;        ///< of covariates at risk
  MatrixXd covariance;  ///< likewise
};

/// The hazards of some steps, and the same times the means of the covariates at risk.
struct Hazards {
  explicit Hazards(Index p) : means(VectorXd::Zero(p)), squaredMeans(MatrixXd::Zero(p, p)) {}

  double sum = 0;
  VectorXd means;
  MatrixXd squaredMeans;

  void add(const RiskStep& step, double share) {
    const double hazard = share / step.mass;
    sum += hazard;
    means += hazard * step.mean;
    squaredMeans += hazard * step.mean * step.mean.transpose();
  }
  void add(const Hazards& other) {
    sum += other.sum;
    means += other.means;
    squaredMeans += other.squaredMeans;
  }
};

class PartialLikelihood {
 public:
  PartialLikelihood(const SurvivalData& data, const MatrixXd& covariates) : data_(data), x_(covariates) {
    order_.resize(data.times.size());
    std::iota(order_.begin(), order_.end(), size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](size_t a, size_t b) {
      return stratum(a) != stratum(b) ? stratum(a) < stratum(b) : data.times[a].seconds > data.times[b].seconds;
    });
  }

  struct Value {
    double logLikelihood = 0;
    VectorXd score;
    MatrixXd information;
  };

  Value at(const VectorXd& beta) const {
    const Index p = x_.cols();
    Value value{0, VectorXd::Zero(p), MatrixXd::Zero(p, p)};
    const VectorXd eta = x_ * beta;
    visit(eta, [&](const RiskStep& step) {
      value.logLikelihood -= std::log(step.mass);
      value.score -= step.mean;
      value.information += step.covariance;
    });
    for (size_t i = 0; i < data_.times.size(); ++i) {
      if (data_.times[i].observed) {
        value.logLikelihood += eta[static_cast<Index>(i)];
        value.score += x_.row(static_cast<Index>(i)).transpose();
      }
    }
    return value;
  }

  /// What each trial tells. A row of `scores` is its share in the score, with what it adds to the hazards of others;
  /// its information is that of the means of covariates at the events that it was at risk for.
  struct OfTrials {
    MatrixXd scores;
    std::vector<MatrixXd> information;
  };
  OfTrials ofTrials(const VectorXd& beta) const {
    const Index p = x_.cols();
    const VectorXd eta = x_ * beta;
    struct Moment {
      Hazards all, ofDying;
      VectorXd mean;
    };
    std::vector<Moment> moments;
    visit(eta, [&](const RiskStep& step) {
      if (moments.size() <= step.moment) {
        moments.resize(step.moment + 1, {Hazards(p), Hazards(p), VectorXd::Zero(p)});
      }
      Moment& moment = moments[step.moment];
      moment.all.add(step, 1);
      moment.ofDying.add(step, 1 - static_cast<double>(step.step) / step.deaths);
      moment.mean += step.mean / step.deaths;
    });
    OfTrials trials{MatrixXd::Zero(x_.rows(), p), std::vector<MatrixXd>(static_cast<size_t>(x_.rows()))};
    // Upwards through the times of each stratum, which stand from last to first.
    Hazards hazards(p);
    size_t moment = moments.size();
    for (size_t end = order_.size(); end > 0;) {
      size_t begin = end - 1;
      while (begin > 0 && isTied(order_[begin - 1], order_[end - 1])) {
        --begin;
      }
      if (end == order_.size() || stratum(order_[end]) != stratum(order_[end - 1])) {
        hazards = Hazards(p);
      }
      const bool anyEvent = std::any_of(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                                        order_.begin() + static_cast<std::ptrdiff_t>(end),
                                        [&](size_t i) { return data_.times[i].observed; });
      const Moment* now = anyEvent ? &moments[--moment] : nullptr;
      for (size_t k = begin; k < end; ++k) {
        const auto i = static_cast<Index>(order_[k]);
        const VectorXd x = x_.row(i).transpose();
        Hazards own = hazards;
        if (data_.times[order_[k]].observed) {
          own.add(now->ofDying);
          trials.scores.row(i) += (x - now->mean).transpose();
        } else if (now != nullptr) {
          own.add(now->all);
        }
        trials.scores.row(i) -= std::exp(eta[i]) * (x * own.sum - own.means).transpose();
        trials.information[order_[k]] = std::exp(eta[i]) * (own.sum * x * x.transpose() - own.means * x.transpose() -
                                                            x * own.means.transpose() + own.squaredMeans);
      }
      if (now != nullptr) {
        hazards.add(now->all);
      }
      end = begin;
    }
    return trials;
  }

  /// Calls `function` with each step, strata in order, times from the last to the first.
  template <class Function>
  void visit(const VectorXd& eta, Function function) const {
    const Index p = x_.cols();
    double mass = 0;
    VectorXd sum(p);
    MatrixXd squares(p, p);
    RiskStep step;
    for (size_t begin = 0; begin < order_.size();) {
      if (begin == 0 || stratum(order_[begin]) != stratum(order_[begin - 1])) {
        mass = 0;
        sum.setZero();
        squares.setZero();
      }
      double dyingMass = 0;
      VectorXd dyingSum = VectorXd::Zero(p);
      MatrixXd dyingSquares = MatrixXd::Zero(p, p);
      step.deaths = 0;
      size_t end = begin;
      for (; end < order_.size() && isTied(order_[begin], order_[end]); ++end) {
        const auto i = static_cast<Index>(order_[end]);
        const VectorXd x = x_.row(i).transpose();
        const double risk = std::exp(eta[i]);
        mass += risk;
        sum += risk * x;
        squares += risk * x * x.transpose();
        if (data_.times[order_[end]].observed) {
          ++step.deaths;
          dyingMass += risk;
          dyingSum += risk * x;
          dyingSquares += risk * x * x.transpose();
        }
      }
      step.seconds = data_.times[order_[begin]].seconds;
      for (step.step = 0; step.step < step.deaths; ++step.step) {
        const double gone = static_cast<double>(step.step) / step.deaths;
        step.mass = mass - gone * dyingMass;
        step.mean = (sum - gone * dyingSum) / step.mass;
        step.covariance = (squares - gone * dyingSquares) / step.mass - step.mean * step.mean.transpose();
        function(std::as_const(step));
      }
      step.moment += step.deaths > 0 ? 1 : 0;
      begin = end;
    }
  }

 private:
  int stratum(size_t i) const { return data_.strata.empty() ? 0 : data_.strata[i]; }
  bool isTied(size_t a, size_t b) const {
    return stratum(a) == stratum(b) && data_.times[a].seconds == data_.times[b].seconds;
  }

  const SurvivalData& data_;
  const MatrixXd& x_;
  std::vector<size_t> order_{};
};

struct CoxMaximum {
  VectorXd beta;
  PartialLikelihood::Value value;
  PartialLikelihood::Value null;
  int iterations = 0;
};

/// Newton's method, with halved steps where the likelihood would fall.
Estimable<CoxMaximum> maximize(const PartialLikelihood& likelihood, const StandardizedCovariates& covariates) {
  using Result = Estimable<CoxMaximum>;
  CoxMaximum maximum;
  maximum.beta = VectorXd::Zero(covariates.values.cols());
  maximum.null = likelihood.at(maximum.beta);
  maximum.value = maximum.null;
  if (const std::string reason = covariates.whyNotIndependent(maximum.null.information); !reason.empty()) {
    return Result::impossible(reason);
  }
  for (maximum.iterations = 1; maximum.iterations <= kCoxIterations; ++maximum.iterations) {
    if (const auto flat = flatDirection(maximum.value.information, maximum.null.information)) {
      return Result::impossible(fmt::format(
          "the likelihood grows without bound in '{}', as where one group has no event or ends first always",
          covariates.names[*flat]));
    }
    const VectorXd step = maximum.value.information.ldlt().solve(maximum.value.score);
    const double promise = step.dot(maximum.value.score);
    if (!(promise > kCoxConverged * (1 + std::abs(maximum.value.logLikelihood)))) {
      return maximum;
    }
    double length = 1;
    PartialLikelihood::Value next = likelihood.at(maximum.beta + step);
    // Near the maximum the likelihood cannot tell steps apart any more.
    const double slack = 1e-13 * std::abs(maximum.value.logLikelihood);
    while (!(next.logLikelihood >= maximum.value.logLikelihood - slack) && length > 1e-6) {
      length /= 2;
      next = likelihood.at(maximum.beta + length * step);
    }
    maximum.beta += length * step;
    maximum.value = next;
  }
  return Result::impossible(fmt::format("the fit did not converge in {} steps", kCoxIterations));
}

/// Of matrices of trials, of the same size.
std::function<MatrixXd(const std::vector<size_t>&)> sumOf(const std::vector<MatrixXd>& ofTrials) {
  return [&ofTrials](const std::vector<size_t>& trials) {
    MatrixXd sum = ofTrials.front();
    sum.setZero();
    for (const size_t trial : trials) {
      sum += ofTrials[trial];
    }
    return sum;
  };
}

Estimable<CoxMaximum> maximize(const SurvivalData& data, const PartialLikelihood& likelihood,
                               const StandardizedCovariates& covariates) {
  if (std::none_of(data.times.begin(), data.times.end(), [](const SurvivalTime& time) { return time.observed; })) {
    return Estimable<CoxMaximum>::impossible(fmt::format("none of {} trials ended by itself", data.times.size()));
  }
  if (!covariates.problem.empty()) {
    return Estimable<CoxMaximum>::impossible(covariates.problem);
  }
  if (std::all_of(data.times.begin(), data.times.end(), [&](const SurvivalTime& time) {
        return time.observed && time.seconds == data.times.front().seconds;
      })) {
    return Estimable<CoxMaximum>::impossible(fmt::format("all {} trials ended at the same moment", data.times.size()));
  }
  return maximize(likelihood, covariates);
}

}  // namespace

Estimable<CoxFit> fitCox(const SurvivalData& data, double level) {
  checkSurvivalData(data, "fitCox");
  const StandardizedCovariates covariates(data.covariates, data.times.size(), "fitCox");
  const PartialLikelihood likelihood(data, covariates.values);
  const Estimable<CoxMaximum> maximum = maximize(data, likelihood, covariates);
  if (!maximum) {
    return Estimable<CoxFit>::impossible(maximum.reason());
  }
  const Index p = covariates.values.cols();
  const MatrixXd model = maximum->value.information.inverse();
  MatrixXd covariance = model;
  std::optional<JackknifeCovariance> jackknife;
  std::vector<bool> unknown(static_cast<size_t>(p), false);
  const CrossedClusters clusters = crossedClusters(data.clusters, data.items);
  if (clusters.first.count > 0) {
    if (clusters.degreesOfFreedom() < static_cast<double>(p)) {
      return Estimable<CoxFit>::impossible(fewClusters(clusters, static_cast<size_t>(p)));
    }
    const PartialLikelihood::OfTrials trials = likelihood.ofTrials(maximum->beta);
    if (data.fewClusters) {
      jackknife = jackknifeCovariance({trials.scores, maximum->value.information, sumOf(trials.information)}, clusters);
      unknown = restOnOneCluster(covariates.values, clusters);
    }
    covariance = jackknife ? jackknife->covariance : sandwich(trials.scores, model, clusters);
    if (!((covariance.diagonal().array() > kCoxLeastShare * model.diagonal().array()).all())) {
      return Estimable<CoxFit>::impossible("all subjects are alike, so that robust errors would be 0");
    }
  }
  CoxFit fit;
  fit.logLikelihood = maximum->value.logLikelihood;
  fit.nullLogLikelihood = maximum->null.logLikelihood;
  fit.iterations = maximum->iterations;
  fit.trials = data.times.size();
  fit.clusters = clusters.first.count;
  fit.events = static_cast<size_t>(
      std::count_if(data.times.begin(), data.times.end(), [](const SurvivalTime& time) { return time.observed; }));
  const auto df = static_cast<double>(p);
  fit.likelihoodRatio = chiSquaredEstimate(2 * (fit.logLikelihood - fit.nullLogLikelihood), df);
  if (std::find(unknown.begin(), unknown.end(), true) == unknown.end()) {
    fit.wald = chiSquaredEstimate(maximum->beta.dot(covariance.ldlt().solve(maximum->beta)), df);
  }
  for (Index j = 0; j < p; ++j) {
    const double scale = covariates.scale[j];
    const double error = unknown[static_cast<size_t>(j)] ? kNotKnown : std::sqrt(covariance(j, j)) / scale;
    const Estimate logarithm = waldEstimate(maximum->beta[j] / scale, error, level,
                                            jackknife ? jackknife->degreesOfFreedom(j, clusters) : kInfinite);
    fit.terms.push_back(
        {covariates.names[static_cast<size_t>(j)], logarithm, asRatio(logarithm), std::sqrt(model(j, j)) / scale});
  }
  const VectorXd inverseScale = covariates.scale.cwiseInverse();
  fit.covariance = rowsOf(inverseScale.asDiagonal() * covariance * inverseScale.asDiagonal());
  return fit;
}

Estimable<ProportionalityTest> testProportionality(const SurvivalData& data, TimeScale scale) {
  using Result = Estimable<ProportionalityTest>;
  checkSurvivalData(data, "testProportionality");
  const StandardizedCovariates covariates(data.covariates, data.times.size(), "testProportionality");
  const PartialLikelihood likelihood(data, covariates.values);
  const Estimable<CoxMaximum> maximum = maximize(data, likelihood, covariates);
  if (!maximum) {
    return Result::impossible(maximum.reason());
  }
  // The time scale, from its mean over the events.
  const std::vector<SurvivalStep> steps = survivalCurve(data.times)->steps;
  const auto scaled = [&](double seconds) {
    if (scale == TimeScale::kSeconds) {
      return seconds;
    }
    const auto at = std::lower_bound(steps.begin(), steps.end(), seconds, [](const SurvivalStep& step, double value) {
      return step.riskSet.seconds < value;
    });
    return at == steps.begin() ? 0.0 : 1 - std::prev(at)->survival;
  };
  double sum = 0, events = 0;
  for (const SurvivalTime& time : data.times) {
    if (time.observed) {
      sum += scaled(time.seconds);
      ++events;
    }
  }
  const double mean = sum / events;
  // Each covariate once more, multiplied with the time: its coefficient is 0 where the ratio is constant.
  const Index p = covariates.values.cols();
  VectorXd score = VectorXd::Zero(p);
  MatrixXd cross = MatrixXd::Zero(p, p), own = MatrixXd::Zero(p, p);
  likelihood.visit(covariates.values * maximum->beta, [&](const RiskStep& step) {
    const double g = scaled(step.seconds) - mean;
    score -= g * step.mean;
    cross += g * step.covariance;
    own += g * g * step.covariance;
  });
  for (size_t i = 0; i < data.times.size(); ++i) {
    if (data.times[i].observed) {
      score += (scaled(data.times[i].seconds) - mean) * covariates.values.row(static_cast<Index>(i)).transpose();
    }
  }
  const MatrixXd variance = own - cross.transpose() * maximum->value.information.ldlt().solve(cross);
  const Eigen::FullPivLU<MatrixXd> decomposition(variance);
  if (!decomposition.isInvertible()) {
    return Result::impossible("too few events at different times");
  }
  ProportionalityTest test;
  test.names = covariates.names;
  for (Index j = 0; j < p; ++j) {
    test.terms.push_back(chiSquaredEstimate(score[j] * score[j] / variance(j, j), 1));
  }
  test.all = chiSquaredEstimate(score.dot(decomposition.solve(score)), static_cast<double>(p));
  return test;
}

}  // namespace ocelli
