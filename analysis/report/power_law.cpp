#include "analysis/report/power_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/models/linear_mixed_model.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr const char* kTruth = "log truth";

std::string levelName(const ViewConditions& conditions, size_t condition) {
  return fmt::format("level of {}", conditions.list[condition].name);
}
std::string slopeName(const ViewConditions& conditions, size_t condition) {
  return fmt::format("slope of {}", conditions.list[condition].name);
}

/// What varies, from the most that is planned to the least.
struct Structure {
  bool slopes;      ///< of log truth by subject
  bool conditions;  ///< intercepts, and slopes, of subjects and cases in each condition
  bool cases;
  const char* text;
};
constexpr Structure kStructures[] = {
    {true, true, true,
     "(1 + log truth || subject) + (1 + log truth || subject:condition) + (1 | case) + (1 | case:condition)"},
    {true, false, true, "(1 + log truth || subject) + (1 | case)"},
    {true, false, false, "(1 + log truth || subject)"},
    {false, false, false, "(1 | subject)"}};

class PowerLawDesign {
 public:
  PowerLawDesign(const ViewConditions& conditions, const EstimateTrials& estimates, double center)
      : fixed_(static_cast<Eigen::Index>(estimates.trials.size())),
        slopes_(static_cast<Eigen::Index>(estimates.trials.size())) {
    std::vector<double> truths;
    for (size_t i = 0; i < estimates.trials.size(); ++i) {
      const Trial& trial = *estimates.trials[i];
      truths.push_back(std::log(estimates.values[i].truth) - center);
      subjects_.push_back(trial.subject);
      cases_.push_back(trial.item());
      views_.push_back(std::to_string(indexOfCondition(trial.view)));
    }
    slopes_.addNumber(kTruth, truths);
    for (size_t condition = 0; condition < conditions.size(); ++condition) {
      std::vector<double> level;
      std::vector<double> slope;
      for (size_t i = 0; i < truths.size(); ++i) {
        level.push_back(views_[i] == std::to_string(condition) ? 1 : 0);
        slope.push_back(level.back() * truths[i]);
      }
      fixed_.addNumber(levelName(conditions, condition), level);
      fixed_.addNumber(slopeName(conditions, condition), slope);
    }
  }

  bool hasSeveralViews() const {
    return std::any_of(views_.begin(), views_.end(), [&](const std::string& view) { return view != views_.front(); });
  }

  Design of(const Structure& structure) const {
    std::vector<RandomTerm> random{bySubject("subject", subjects_, structure.slopes)};
    if (structure.conditions) {
      random.push_back(bySubject("subject:condition", nestedLevels(subjects_, views_), structure.slopes));
    }
    if (structure.cases) {
      random.push_back(randomIntercepts("case", cases_));
      if (structure.conditions) {
        random.push_back(randomIntercepts("case:condition", nestedLevels(cases_, views_)));
      }
    }
    return makeDesign(fixed_, random);
  }

 private:
  RandomTerm bySubject(const std::string& group, const std::vector<std::string>& levels, bool slopes) const {
    RandomTerm term = randomIntercepts(group, levels);
    if (slopes) {
      addSlope(term, kTruth, slopes_);
      term.correlated = false;
    }
    return term;
  }

  FixedEffects fixed_;
  FixedEffects slopes_;
  std::vector<std::string> subjects_{};
  std::vector<std::string> cases_{};
  std::vector<std::string> views_{};
};

/// second less first; impossible where either is not estimated.
Estimable<Estimate> coefficientDifference(const LinearMixedFit& fit, const std::string& first,
                                          const std::string& second) {
  const Estimable<Eigen::Index> from = coefficientIndex(fit, first);
  const Estimable<Eigen::Index> to = coefficientIndex(fit, second);
  if (!from || !to) {
    return Estimable<Estimate>::impossible("one of the conditions has no slope of its own");
  }
  Eigen::VectorXd contrast = Eigen::VectorXd::Zero(fit.coefficients.size());
  contrast[*to] = 1;
  contrast[*from] = -1;
  return contrastEstimate(fit, contrast);
}

/// A level without trials is a column of zeros, which is dropped.
Estimable<Estimate> coefficientOrReason(const LinearMixedFit& fit, const std::string& name) {
  return coefficientIndex(fit, name) ? coefficientEstimate(fit, name)
                                     : Estimable<Estimate>::impossible("the condition has no trials that tell it");
}

}  // namespace

Estimable<PowerLawFit> fitPowerLaw(const ViewConditions& conditions, const EstimateTrials& estimates) {
  using Result = Estimable<PowerLawFit>;
  if (estimates.trials.empty()) {
    return Result::impossible("no trial holds an estimate");
  }
  OC_CHECK(!estimates.unit->isDirection, "power laws are of lengths");
  PowerLawFit result;
  result.trials = estimates.trials;
  const auto rows = static_cast<double>(estimates.trials.size());
  Eigen::VectorXd response(static_cast<Eigen::Index>(estimates.trials.size()));
  bool varies = false;
  for (size_t i = 0; i < estimates.trials.size(); ++i) {
    result.logCenter += std::log(estimates.values[i].truth) / rows;
    response[static_cast<Eigen::Index>(i)] = std::log(estimates.values[i].estimate);
    varies = varies || estimates.values[i].truth != estimates.values[0].truth;
  }
  if (!varies) {
    return Result::impossible("all true lengths are the same");
  }
  const PowerLawDesign design(conditions, estimates, result.logCenter);
  std::string reason;
  for (const Structure& structure : kStructures) {
    if (structure.conditions && !design.hasSeveralViews()) {
      continue;
    }
    const Estimable<LinearMixedFit> fit = LinearMixedModel(design.of(structure)).fit(response);
    if (!fit || !fit->convergence.converged) {
      reason = fit ? fit->convergence.reason : fit.reason();
      continue;
    }
    result.structure = structure.text;
    result.warnings = fit->warnings;
    for (size_t i = 0; i < conditions.size(); ++i) {
      PowerLaw law;
      law.exponent = coefficientOrReason(*fit, slopeName(conditions, i));
      law.logAtCenter = coefficientOrReason(*fit, levelName(conditions, i));
      if (i > 0) {
        law.difference = coefficientDifference(*fit, slopeName(conditions, 0), slopeName(conditions, i));
      }
      result.conditions.push_back(law);
    }
    return result;
  }
  return Result::impossible(reason);
}

}  // namespace ocelli
