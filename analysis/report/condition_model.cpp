#include "analysis/report/condition_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/censored_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"
#include "analysis/report/error_model.h"
#include "analysis/report/planned_design.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/right_answers.h"

namespace ocelli {
namespace {

constexpr int kMinGroupLevels = 3;
constexpr int kMinTrialsOfLabel = 2;
constexpr double kNotEstimable = 1e-6;  ///< of a contrast's length: what no trial tells of it

struct ConditionStructure {
  std::vector<RandomEffect> effects{};
  std::vector<std::string> reasons{};
};

struct Slope {
  size_t effect = 0;
  size_t slope = 0;
};

std::vector<Slope> slopesIn(const ConditionStructure& structure) {
  std::vector<Slope> slopes;
  for (size_t effect = 0; effect < structure.effects.size(); ++effect) {
    for (size_t slope = structure.effects[effect].slopes.size(); slope-- > 0;) {
      slopes.push_back({effect, slope});
    }
  }
  return slopes;
}

ConditionStructure without(const ConditionStructure& structure, const Slope& slope, const std::string& why) {
  ConditionStructure simpler = structure;
  RandomEffect& effect = simpler.effects[slope.effect];
  simpler.reasons.push_back(
      fmt::format("the slope of {} by {} is left out: {}", effect.slopes[slope.slope], effect.group, why));
  effect.slopes.erase(effect.slopes.begin() + static_cast<std::ptrdiff_t>(slope.slope));
  return simpler;
}

std::vector<std::string> groupOf(const ConditionTerms& terms, const std::string& group) {
  if (group == "subject") {
    return subjectsOf(terms.trials());
  }
  std::vector<std::string> items;
  for (const Trial* trial : terms.trials()) {
    items.push_back(trial->item());
  }
  return items;
}

/// How many levels of the group have two or more trials with each of two labels.
int levelsThatTell(const std::vector<std::string>& groups, const std::vector<std::string>& labels) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (size_t i = 0; i < groups.size(); ++i) {
    ++counts[groups[i]][labels[i]];
  }
  return static_cast<int>(std::count_if(counts.begin(), counts.end(), [](const auto& level) {
    return std::count_if(level.second.begin(), level.second.end(),
                         [](const auto& label) { return label.second >= kMinTrialsOfLabel; }) >= 2;
  }));
}

ConditionStructure byDesign(const PlannedModel& model, const ConditionTerms& terms) {
  ConditionStructure structure{model.randomEffects};
  for (const Slope& slope : slopesIn(structure)) {
    const std::string term = structure.effects[slope.effect].slopes[slope.slope];
    if (!terms.isCategorical(term) &&
        std::find(terms.terms().begin(), terms.terms().end(), term) == terms.terms().end()) {
      structure = without(structure, slope, "it is no term of the model that varies");
    }
  }
  for (const Slope& slope : slopesIn(structure)) {
    const RandomEffect effect = structure.effects[slope.effect];
    const std::string& term = effect.slopes[slope.slope];
    if (!terms.isCategorical(term)) {
      continue;
    }
    const std::vector<std::string> groups = groupOf(terms, effect.group);
    const std::vector<std::string> labels = terms.labelsOf(term);
    const size_t cells = randomIntercepts(effect.group, nestedLevels(groups, labels)).levels.size();
    if (const int levels = levelsThatTell(groups, labels); levels < kMinGroupLevels) {
      structure =
          without(structure, slope,
                  fmt::format("{} levels have {} or more trials in each of two of its levels, and {} are needed "
                              "to tell how they differ in it",
                              levels, kMinTrialsOfLabel, kMinGroupLevels));
    } else if (cells >= terms.trials().size()) {
      structure = without(structure, slope,
                          fmt::format("{} trials are too few for {} random effects", terms.trials().size(), cells));
    }
  }
  return structure;
}

Design designOf(const ConditionTerms& terms, const ConditionStructure& structure) {
  const FixedEffects fixed = terms.columns();
  std::vector<RandomTerm> random;
  for (const RandomEffect& effect : structure.effects) {
    const std::vector<std::string> groups = groupOf(terms, effect.group);
    RandomTerm intercepts = randomIntercepts(effect.group, groups);
    std::vector<RandomTerm> nested;
    for (const std::string& slope : effect.slopes) {
      if (terms.isCategorical(slope)) {
        nested.push_back(
            randomIntercepts(fmt::format("{}:{}", effect.group, slope), nestedLevels(groups, terms.labelsOf(slope))));
      } else {
        addSlope(intercepts, slope, fixed);
      }
    }
    intercepts.correlated = false;
    random.push_back(std::move(intercepts));
    std::move(nested.begin(), nested.end(), std::back_inserter(random));
  }
  return makeDesign(fixed, random);
}

/// The fit of the planned structure, as far as the data tell it. `fitDesign`: an Estimable fit of a Design.
template <class FitDesign>
auto fitStructure(const ConditionTerms& terms, ConditionStructure& structure, const FitDesign& fitDesign) {
  auto fit = fitDesign(designOf(terms, structure));
  for (std::vector<Slope> slopes = slopesIn(structure); fit && !slopes.empty(); slopes = slopesIn(structure)) {
    const bool converged = fit->convergence.converged;
    double minRise = std::numeric_limits<double>::infinity();
    Slope weakest = slopes.front();
    auto simplerFit = fit;
    for (const Slope& slope : slopes) {
      const auto other = fitDesign(designOf(terms, without(structure, slope, "")));
      const double rise = other && other->convergence.converged ? other->deviance - fit->deviance
                                                                : std::numeric_limits<double>::infinity();
      if (rise < minRise) {
        minRise = rise;
        weakest = slope;
        simplerFit = other;
      }
    }
    if (std::isinf(minRise) || (converged && !(minRise < kMinDevianceRise))) {
      break;
    }
    structure = without(
        structure, weakest,
        converged ? fmt::format("without it the restricted deviance rises by {:.2f}, and slopes stay from {:.2f} on "
                                "(p < 0.25)",
                                std::max(0.0, minRise), kMinDevianceRise)
                  : std::string("the fit did not converge with it"));
    fit = simplerFit;
  }
  return fit;
}

/// Whether trials tell a sum of rows of the grid: whether it is a sum of rows of the trials' columns.
bool isEstimable(const Eigen::MatrixXd& columns, const Eigen::VectorXd& row) {
  const Eigen::MatrixXd square = columns.transpose() * columns;
  const Eigen::VectorXd solution = square.completeOrthogonalDecomposition().solve(row);
  return (square * solution - row).norm() <= kNotEstimable * std::max(1.0, row.norm());
}

/// What the fit says of sums of rows of the grid.
class GridSums {
 public:
  GridSums(const ConditionTerms& terms, const Design& design, const MixedModelFit& fit)
      : columns_(terms.columns().columns()),
        grid_(terms.gridColumns().columns()),
        kept_(design.rowsLike(terms.gridColumns())),
        fit_(fit) {}

  Estimable<Estimate> of(const std::vector<double>& weights) const {
    const Eigen::Map<const Eigen::VectorXd> each(weights.data(), static_cast<Eigen::Index>(weights.size()));
    if (!isEstimable(columns_, grid_.transpose() * each)) {
      return Estimable<Estimate>::impossible("some of what is compared has no trials");
    }
    return contrastEstimate(fit_, kept_.transpose() * each);
  }

 private:
  Eigen::MatrixXd columns_;
  Eigen::MatrixXd grid_;
  Eigen::MatrixXd kept_;
  const MixedModelFit& fit_;
};

void describeConditions(const ConditionTerms& terms, const ConditionStructure& structure,
                        const std::vector<PlannedContrast>& contrasts, const MixedModelFit& fit, ConditionFit& result) {
  const Design design = designOf(terms, structure);
  const GridSums sums(terms, design, fit);
  for (size_t i = 0; i < terms.conditions().size(); ++i) {
    result.means.push_back(sums.of(weightsOfCondition(i, terms)));
  }
  for (const PlannedContrast& contrast : contrasts) {
    const Estimable<std::vector<double>> weights = weightsOf(contrast, terms);
    result.contrasts.push_back(
        {contrast, weights ? sums.of(*weights) : Estimable<Estimate>::impossible(weights.reason())});
  }
  const FixedEffects columns = terms.columns();
  for (const std::string& term : terms.terms()) {
    const std::vector<Eigen::Index> ofTerm = columns.columnsOf(term);
    if (term != "view" && ofTerm.size() == 1) {
      result.covariates.push_back(
          {term, coefficientEstimate(fit, columns.names()[static_cast<size_t>(ofTerm.front())])});
    }
  }
  for (const RandomTermFit& term : fit.random) {
    for (size_t i = 0; i < term.names.size(); ++i) {
      const std::string name = term.names[i] == "(intercept)" ? "" : " " + term.names[i];
      result.random.push_back(fmt::format("{}{}: standard deviation {:.3f}", term.group, name,
                                          term.standardDeviations[static_cast<Eigen::Index>(i)]));
    }
  }
  result.structure = conditionStructureText(structure.effects);
  result.leftOut = terms.leftOut();
  result.leftOut.insert(result.leftOut.end(), structure.reasons.begin(), structure.reasons.end());
  result.warnings = fit.warnings;
  result.search = fmt::format("the search for the optimum {} after {} evaluations, and {}",
                              fit.convergence.converged ? "converged" : "did not converge", fit.convergence.evaluations,
                              fit.singular ? "the fit is singular" : "no variance is 0");
  result.trials = terms.trials();
}

template <class FitDesign>
Estimable<ConditionFit> fitByTerms(const PlannedModel& model, const ConditionTerms& terms,
                                   const std::vector<PlannedContrast>& contrasts, const FitDesign& fitDesign) {
  if (terms.trials().empty()) {
    return Estimable<ConditionFit>::impossible("there are no trials");
  }
  ConditionStructure structure = byDesign(model, terms);
  const auto fit = fitStructure(terms, structure, fitDesign);
  if (!fit) {
    return Estimable<ConditionFit>::impossible(fit.reason());
  }
  ConditionFit result;
  describeConditions(terms, structure, contrasts, *fit, result);
  return result;
}

}  // namespace

std::string conditionStructureText(const std::vector<RandomEffect>& effects) {
  std::vector<std::string> all;
  for (const RandomEffect& effect : effects) {
    all.push_back(fmt::format("(1 | {})", effect.group));
    for (const std::string& slope : effect.slopes) {
      all.push_back(fmt::format("(1 | {}:{})", effect.group, slope));
    }
  }
  return fmt::format("{}", fmt::join(all, " + "));
}

Estimable<ConditionFit> fitConditions(const Dataset& data, const PlannedModel& model, const TrialList& trials,
                                      TimeoutTreatment timeouts, const std::vector<PlannedContrast>& contrasts) {
  const bool isOfAnswers = model.kind == ModelKind::kBinomialMixed;
  const bool isOfErrors = modelOutcomeOf(model.kind) == ModelOutcome::kEstimates;
  const ConditionTerms terms(data, model,
                             isOfErrors    ? estimatesIn(trials).trials
                             : isOfAnswers ? answeredTrials(trials)
                                           : searchesOfMixedModel(model, trials, timeouts));
  if (const std::string problem = terms.problem(); !problem.empty()) {
    return Estimable<ConditionFit>::impossible(problem);
  }
  if (isOfAnswers) {
    std::vector<bool> right;
    for (const Trial* trial : terms.trials()) {
      right.push_back(trial->correct.value_or(false));
    }
    const BinomialResponse response = binaryResponse(right);
    return fitByTerms(model, terms, contrasts,
                      [&](Design design) { return BinomialMixedModel(std::move(design)).fitRestricted(response); });
  }
  if (isOfErrors) {
    const Estimable<ErrorResponse> response = errorResponse(model, terms.trials());
    if (!response) {
      return Estimable<ConditionFit>::impossible(response.reason());
    }
    const Eigen::Map<const Eigen::VectorXd> values(response->values.data(),
                                                   static_cast<Eigen::Index>(response->values.size()));
    const Estimable<ConditionFit> fit = fitByTerms(
        model, terms, contrasts, [&](Design design) { return LinearMixedModel(std::move(design)).fit(values); });
    if (!fit) {
      return fit;
    }
    ConditionFit told = *fit;
    told.notes = notesOfErrors(model, terms.trials(), *response);
    return told;
  }
  const bool knowsCensored = timesTreatmentOf(model, timeouts) == TimeoutTreatment::kCensored;
  CensoredResponse response{Eigen::VectorXd(static_cast<Eigen::Index>(terms.trials().size())), {}};
  bool anyCensored = false;
  for (size_t i = 0; i < terms.trials().size(); ++i) {
    const Trial& trial = *terms.trials()[i];
    response.values[static_cast<Eigen::Index>(i)] = std::log(*trial.responseSeconds);
    response.censored.push_back(knowsCensored && trial.censored.value_or(false));
    anyCensored = anyCensored || response.censored.back();
  }
  if (anyCensored) {
    return fitByTerms(model, terms, contrasts,
                      [&](Design design) { return CensoredMixedModel(std::move(design)).fitRestricted(response); });
  }
  return fitByTerms(model, terms, contrasts,
                    [&](Design design) { return LinearMixedModel(std::move(design)).fit(response.values); });
}

}  // namespace ocelli
