#include "analysis/models/censored_mixed_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/base/normal_tail.h"
#include "analysis/models/laplace_fit.h"
#include "analysis/models/separation.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A residual deviation below this share of that about the least-squares fit: random effects reproduce the response.
constexpr double kNoDeviation = 1e-4;

/// log density of a normal response, or log probability of what lies above a censored one. Its parameter is the
/// logarithm of the residual standard deviation.
class CensoredFamily : public ResponseFamily {
 public:
  CensoredFamily(VectorXd values, const std::vector<bool>& censored) : values_(std::move(values)), censored_(censored) {
    observed_ = std::count(censored.begin(), censored.end(), false);
  }

  Index parameterCount() const override { return 1; }
  void setParameters(const VectorXd& values) override {
    deviation_ = std::exp(values[0]);
    constant_ = static_cast<double>(observed_) * (std::log(2 * std::numbers::pi) + 2 * values[0]);
  }
  double scale() const override { return deviation_; }

  void evaluate(const VectorXd& predictor) override {
    const VectorXd z = (values_ - predictor) / deviation_;
    slopes_ = z / deviation_;
    curvatures_ = VectorXd::Constant(z.size(), 1 / (deviation_ * deviation_));
    deviance_ = 0;
    for (Index row = 0; row < z.size(); ++row) {
      if (censored_[static_cast<size_t>(row)]) {
        const double hazard = normalHazard(z[row]);
        slopes_[row] = hazard / deviation_;
        curvatures_[row] *= hazard * (hazard - z[row]);
        deviance_ -= 2 * logNormalTail(z[row]);
      } else {
        deviance_ += z[row] * z[row];
      }
    }
  }

  double logDensity(Index row, double predictor) const override {
    const double z = (values_[row] - predictor) / deviation_;
    return censored_[static_cast<size_t>(row)] ? logNormalTail(z) : -z * z / 2;
  }

 private:
  VectorXd values_;
  const std::vector<bool>& censored_;
  Index observed_ = 0;
  double deviation_ = 1;
};

/// Whether the fixed effects give the rows that are not censored without residuals.
bool fixedEffectsReproduce(const Design& design, const CensoredResponse& response) {
  std::vector<Index> observed;
  for (size_t row = 0; row < response.censored.size(); ++row) {
    if (!response.censored[row]) {
      observed.push_back(static_cast<Index>(row));
    }
  }
  const MatrixXd columns = design.fixed(observed, Eigen::all);
  const VectorXd values = response.values(observed);
  const VectorXd rest = values - columns * columns.colPivHouseholderQr().solve(values);
  return rest.norm() <= kNoResiduals * values.norm();
}

VectorXd withDeviation(const VectorXd& theta, double residualDeviation) {
  VectorXd variances(theta.size() + 1);
  variances << theta, std::log(residualDeviation);
  return variances;
}

}  // namespace

CensoredMixedModel::CensoredMixedModel(Design design)
    : design_(std::move(design)), structure_(design_.random, design_.rows()) {}

void CensoredMixedModel::check(const CensoredResponse& response) const {
  if (response.values.size() != design_.rows() || !response.values.allFinite() ||
      response.censored.size() != static_cast<size_t>(design_.rows())) {
    throw InputError("the response has a value that is not finite, or not one a row", "censored mixed model",
                     "rows without missing values");
  }
}

std::optional<std::string> CensoredMixedModel::whyNot(const CensoredResponse& response) const {
  if (std::optional<std::string> reason = whyImpossible(design_, true)) {
    return reason;
  }
  if (std::all_of(response.censored.begin(), response.censored.end(), [](bool censored) { return censored; })) {
    return "all responses are censored";
  }
  if (fixedEffectsReproduce(design_, response)) {
    return "the fixed effects reproduce the responses that are not censored exactly";
  }
  // As answers: a censored row wants the predictor large, the others want it where it is.
  const VectorXd ones = VectorXd::Ones(design_.rows());
  VectorXd trials = ones;
  for (Index row = 0; row < trials.size(); ++row) {
    trials[row] = response.censored[static_cast<size_t>(row)] ? 1 : 2;
  }
  const std::vector<std::string> names = separatedCoefficients(design_, ones, trials);
  if (!names.empty()) {
    return fmt::format("all responses are censored in some combination of conditions, where {} {}",
                       fmt::join(names, ", "),
                       names.size() == 1 ? "has no finite estimate" : "have no finite estimates");
  }
  return std::nullopt;
}

double CensoredMixedModel::deviance(const CensoredResponse& response, const VectorXd& theta, double residualDeviation,
                                    const VectorXd& coefficients, int quadraturePoints) const {
  check(response);
  CensoredFamily family(response.values, response.censored);
  LaplaceIntegral integral(structure_, family, design_.fixed, quadraturePoints);
  return integral.at(withDeviation(structure_.scaledThetaOf(theta), residualDeviation), coefficients);
}

double CensoredMixedModel::restrictedDeviance(const CensoredResponse& response, const VectorXd& theta,
                                              double residualDeviation) const {
  check(response);
  CensoredFamily family(response.values, response.censored);
  LaplaceIntegral integral(structure_, family, design_.fixed);
  return integral.restrictedAt(withDeviation(structure_.scaledThetaOf(theta), residualDeviation));
}

Estimable<CensoredMixedFit> CensoredMixedModel::fitRestricted(const CensoredResponse& response) const {
  using Result = Estimable<CensoredMixedFit>;
  check(response);
  if (const std::optional<std::string> reason = whyNot(response)) {
    return Result::impossible(*reason);
  }
  // What is fitted is less its least-squares fit, censored values as they are, and of unit variance.
  ResponseUnits units;
  units.leastSquares = design_.basis.transpose() * response.values;
  VectorXd rest = response.values - design_.basis * units.leastSquares;
  units.scale = rest.norm() / std::sqrt(rest.size());
  rest /= units.scale;
  CensoredFamily family(rest, response.censored);
  LaplaceIntegral integral(structure_, family, laplaceColumns(design_));
  // With the steps of the linear model, so that both say the same where no row is censored.
  const RestrictedOptimum optimum =
      restrictedOptimum(integral, structure_, withDeviation(structure_.startTheta(), 0.7), MinimumSearch());

  CensoredMixedFit fit;
  describeLaplaceFit(design_, structure_, family, integral, optimum.minimum, optimum.covariance, units, fit);
  if (!(family.scale() > kNoDeviation)) {
    return Result::impossible("fixed and random effects reproduce the responses that are not censored exactly");
  }
  addRestricted(design_, integral, optimum, units, fit);
  fit.censoredRows = static_cast<int>(std::count(response.censored.begin(), response.censored.end(), true));
  fit.deviance += 2 * static_cast<double>(design_.rows() - fit.censoredRows) * std::log(units.scale);
  fit.residualDeviation = units.scale * family.scale();
  fit.fitted = design_.basis * units.leastSquares + units.scale * integral.linearPredictor();
  fit.residuals = response.values - fit.fitted;
  for (Index row = 0; row < fit.residuals.size(); ++row) {
    if (response.censored[static_cast<size_t>(row)]) {
      fit.residuals[row] = fit.residualDeviation * normalHazard(fit.residuals[row] / fit.residualDeviation);
    }
  }
  return fit;
}

}  // namespace ocelli
