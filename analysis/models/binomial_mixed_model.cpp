#include "analysis/models/binomial_mixed_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/models/laplace_fit.h"
#include "analysis/models/separation.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxQuadraturePoints = 25;
/// A relative standard deviation, of logits: odds of e^30 between levels are those of levels that have no common odds.
constexpr double kLargestTheta = 30;

double logBinomialCoefficients(const BinomialResponse& response) {
  double sum = 0;
  for (Index row = 0; row < response.trials.size(); ++row) {
    const double n = response.trials[row];
    const double k = response.successes[row];
    if (k > 0 && k < n) {
      sum += std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
    }
  }
  return sum;
}

std::optional<std::string> whySeparated(const Design& design, const BinomialResponse& response) {
  const std::vector<std::string> names = separatedCoefficients(design, response.successes, response.trials);
  if (names.empty()) {
    return std::nullopt;
  }
  return fmt::format(
      "the answers are separated: they are all of one kind in some combination of conditions, where {} {}",
      fmt::join(names, ", "), names.size() == 1 ? "has no finite estimate" : "have no finite estimates");
}

class BinomialFamily : public ResponseFamily {
 public:
  explicit BinomialFamily(const BinomialResponse& response) : response_(response) {
    constant_ = -2 * logBinomialCoefficients(response);
  }

  void evaluate(const VectorXd& predictor) override {
    const Eigen::ArrayXd shrunk = (-predictor.array().abs()).exp();
    const Eigen::ArrayXd softplus = predictor.array().max(0.0) + (1 + shrunk).log();
    const Eigen::ArrayXd larger = (1 + shrunk).inverse();
    const VectorXd probabilities = (predictor.array() >= 0).select(larger, 1 - larger);
    deviance_ = -2 * (response_.successes.array() * predictor.array() - response_.trials.array() * softplus).sum();
    slopes_ = response_.successes - response_.trials.cwiseProduct(probabilities);
    curvatures_ = response_.trials.array() * probabilities.array() * (1 - probabilities.array());
  }

  double logDensity(Index row, double predictor) const override {
    const double softplus = std::max(predictor, 0.0) + std::log1p(std::exp(-std::abs(predictor)));
    return response_.successes[row] * predictor - response_.trials[row] * softplus;
  }

 private:
  const BinomialResponse& response_;
};

}  // namespace

BinomialResponse binaryResponse(const std::vector<bool>& successes) {
  const auto size = static_cast<Index>(successes.size());
  BinomialResponse response{VectorXd::Zero(size), VectorXd::Ones(size)};
  for (Index row = 0; row < size; ++row) {
    response.successes[row] = successes[static_cast<size_t>(row)] ? 1 : 0;
  }
  return response;
}

BinomialMixedModel::BinomialMixedModel(Design design)
    : design_(std::move(design)), structure_(design_.random, design_.rows()) {}

void BinomialMixedModel::check(const BinomialResponse& response, int quadraturePoints) const {
  const auto fail = [](const std::string& what, const std::string& next) {
    throw InputError(what, "binomial mixed model", next);
  };
  const Index rows = design_.rows();
  if (response.successes.size() != rows || response.trials.size() != rows) {
    fail(fmt::format("the response has not {} rows", rows), "successes and trials of each row");
  }
  for (Index row = 0; row < rows; ++row) {
    const double k = response.successes[row];
    const double n = response.trials[row];
    if (!(n >= 1 && k >= 0 && k <= n && std::floor(n) == n && std::floor(k) == k && std::isfinite(n))) {
      fail(fmt::format("{} successes of {} trials in row {}", k, n, row + 1),
           "whole numbers, 0 to the number of trials");
    }
  }
  const bool scalar = design_.random.size() == 1 && design_.random[0].names.size() == 1;
  if (quadraturePoints < 1 || quadraturePoints > kMaxQuadraturePoints || (quadraturePoints > 1 && !scalar)) {
    fail(fmt::format("{} points of quadrature", quadraturePoints),
         "1 point, or up to 25 for a model with one random effect of one grouping factor");
  }
}

double BinomialMixedModel::deviance(const BinomialResponse& response, const VectorXd& theta,
                                    const VectorXd& coefficients, int quadraturePoints) const {
  check(response, quadraturePoints);
  BinomialFamily family(response);
  LaplaceIntegral integral(structure_, family, design_.fixed, quadraturePoints);
  return integral.at(structure_.scaledThetaOf(theta), coefficients);
}

std::optional<std::string> BinomialMixedModel::whyNot(const BinomialResponse& response) const {
  const bool binary = (response.trials.array() == 1).all();
  if (std::optional<std::string> reason = whyImpossible(design_, binary)) {
    return reason;
  }
  if (response.successes.isZero(0) || response.successes == response.trials) {
    return "all responses are equal";
  }
  return whySeparated(design_, response);
}

Estimable<BinomialMixedFit> BinomialMixedModel::describe(const ResponseFamily& family, LaplaceIntegral& integral,
                                                         const Minimum& minimum, const MatrixXd& covariance) const {
  const VectorXd theta = minimum.point.head(structure_.thetaSize());
  if (theta.lpNorm<Eigen::Infinity>() > kLargestTheta) {
    return Estimable<BinomialMixedFit>::impossible(
        "the levels of a grouping factor differ without limit: each has responses of one kind");
  }
  BinomialMixedFit fit;
  describeLaplaceFit(design_, structure_, family, integral, minimum, covariance, {}, fit);
  fit.linearPredictor = integral.linearPredictor();
  fit.fitted = (1 + (-fit.linearPredictor.array()).exp()).inverse();
  return fit;
}

Estimable<BinomialMixedFit> BinomialMixedModel::fit(const BinomialResponse& response, int quadraturePoints) const {
  check(response, quadraturePoints);
  if (const std::optional<std::string> reason = whyNot(response)) {
    return Estimable<BinomialMixedFit>::impossible(*reason);
  }
  // First theta alone, with the fixed effects at the penalized mode; then both.
  BinomialFamily family(response);
  LaplaceIntegral integral(structure_, family, laplaceColumns(design_), quadraturePoints);
  MinimumSearch first;
  first.lastStep = 0.02;
  const VectorXd start = nearMinimum([&](const VectorXd& theta) { return integral.atBestCoordinates(theta); },
                                     structure_.startTheta(), first);
  integral.whiten(start);
  const Index thetaCount = structure_.thetaSize();
  const Index fixedCount = design_.fixed.cols();
  const Objective deviance = [&](const VectorXd& point) {
    return integral.at(point.head(thetaCount), point.tail(fixedCount));
  };
  VectorXd together = VectorXd::Zero(thetaCount + fixedCount);
  together.head(thetaCount) = start;
  Minimum minimum = findMinimum(deviance, together, laplaceSearch());
  settleAtBoundary(structure_, deviance, minimum);
  const MatrixXd covariance = covarianceOfMinimum(minimum.hessian).bottomRightCorner(fixedCount, fixedCount);
  const Estimable<BinomialMixedFit> fit = describe(family, integral, minimum, covariance);
  if (!fit) {
    return fit;
  }
  BinomialMixedFit result = *fit;
  result.quadraturePoints = quadraturePoints;
  return result;
}

Estimable<BinomialMixedFit> BinomialMixedModel::fitRestricted(const BinomialResponse& response) const {
  check(response, 1);
  if (const std::optional<std::string> reason = whyNot(response)) {
    return Estimable<BinomialMixedFit>::impossible(*reason);
  }
  BinomialFamily family(response);
  LaplaceIntegral integral(structure_, family, laplaceColumns(design_));
  MinimumSearch search = laplaceSearch();
  search.firstStep = 0.5;
  const RestrictedOptimum optimum = restrictedOptimum(integral, structure_, structure_.startTheta(), search);
  const Estimable<BinomialMixedFit> fit = describe(family, integral, optimum.minimum, optimum.covariance);
  if (!fit) {
    return fit;
  }
  BinomialMixedFit result = *fit;
  addRestricted(design_, integral, optimum, {}, result);
  return result;
}

BinomialResponse BinomialMixedModel::simulate(const BinomialMixedFit& fit, const VectorXd& trials,
                                              RandomNumbers& numbers) const {
  const VectorXd u = VectorXd::NullaryExpr(structure_.size(), [&] { return numbers.normal(); });
  const VectorXd b = structure_.lambdaTimes(structure_.scaledThetaOf(fit.theta), u);
  const VectorXd predictor = design_.fixed * fit.coefficients + structure_.times(b);
  BinomialResponse response{VectorXd::Zero(trials.size()), trials};
  for (Index row = 0; row < trials.size(); ++row) {
    const double probability = 1 / (1 + std::exp(-predictor[row]));
    for (int trial = 0; trial < static_cast<int>(trials[row]); ++trial) {
      response.successes[row] += numbers.uniform() < probability ? 1 : 0;
    }
  }
  return response;
}

}  // namespace ocelli
