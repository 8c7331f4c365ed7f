#include "analysis/report/planned_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/censored_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"
#include "analysis/report/planned_design.h"
#include "analysis/report/response_scale.h"

namespace ocelli {
namespace {

PlannedFit describe(const PlannedModel& model, const TrialList& trials, const MixedModelFit& fit) {
  PlannedFit result;
  const FixedEffects fixed = plannedColumns(model, trials, false);
  for (const std::string& term : model.terms) {
    const std::string column = columnOf(fixed, term);
    result.terms.push_back({term, column, coefficientEstimate(fit, column)});
  }
  result.warnings = fit.warnings;
  for (const RandomTermFit& term : fit.random) {
    for (size_t i = 0; i < term.names.size(); ++i) {
      result.random.push_back(fmt::format("{} {}: standard deviation {:.3f}", term.group, term.names[i],
                                          term.standardDeviations[static_cast<Eigen::Index>(i)]));
    }
  }
  for (const RandomTermFit& term : fit.random) {
    for (size_t i = 0; i < term.names.size(); ++i) {
      const auto values = term.effects.col(static_cast<Eigen::Index>(i));
      result.effects.push_back({fmt::format("{} {}", term.group, term.names[i]), {values.begin(), values.end()}});
    }
  }
  result.search = fmt::format("the search for the optimum {} after {} evaluations, and {}",
                              fit.convergence.converged ? "converged" : "did not converge", fit.convergence.evaluations,
                              fit.singular ? "the fit is singular" : "no variance is 0");
  result.fitted.assign(fit.fitted.begin(), fit.fitted.end());
  return result;
}

/// How much worse a fit is without the slope. A search that found no end tells nothing: the slope stays.
template <class Fit>
double devianceRise(const Estimable<Fit>& fit, const Estimable<Fit>& without) {
  return without && without->convergence.converged ? without->deviance - fit->deviance
                                                   : std::numeric_limits<double>::infinity();
}

/// What is fitted of the plan, by the steps of planned_design.h. `fitDesign`: an Estimable fit of a Design.
template <class FitDesign>
auto fitPlanned(const PlannedModel& model, const TrialList& trials, const FitDesign& fitDesign)
    -> std::pair<FittedStructure, decltype(fitDesign(Design{}))> {
  using Result = decltype(fitDesign(Design{}));
  FittedStructure structure = structureByDesign(model, trials);
  Result fit = fitDesign(plannedDesign(model, trials, structure));
  for (std::vector<SlopePlace> slopes = slopesOf(structure); fit && !slopes.empty(); slopes = slopesOf(structure)) {
    const auto least = std::min_element(slopes.begin(), slopes.end(), [&](const SlopePlace& a, const SlopePlace& b) {
      return relativeDeviation(*fit, a) < relativeDeviation(*fit, b);
    });
    if (!fit->convergence.converged) {
      structure = withoutSlope(structure, *least, "the fit did not converge with it");
      fit = fitDesign(plannedDesign(model, trials, structure));
      continue;
    }
    double minRise = std::numeric_limits<double>::infinity();
    FittedStructure simpler;
    Result simplerFit = fit;
    for (const SlopePlace& slope : slopes) {
      if (isClear(*fit, slope)) {
        continue;
      }
      FittedStructure other = withoutSlope(structure, slope, "");
      const Result without = fitDesign(plannedDesign(model, trials, other));
      const double rise = devianceRise(fit, without);
      if (rise < minRise) {
        minRise = rise;
        simplerFit = without;
        simpler = withoutSlope(structure, slope,
                               fmt::format("without it the restricted deviance rises by {:.2f}, and slopes stay from "
                                           "{:.2f} on (p < 0.25)",
                                           std::max(0.0, rise), kMinDevianceRise));
      }
    }
    if (!(minRise < kMinDevianceRise)) {
      break;
    }
    structure = simpler;
    fit = simplerFit;
  }
  return {structure, fit};
}

/// `finish`: adds what only this kind of model has.
template <class FitDesign, class Finish>
Estimable<PlannedFit> fitAndDescribe(const PlannedModel& model, const TrialList& trials, const FitDesign& fitDesign,
                                     const Finish& finish) {
  if (trials.empty()) {
    return Estimable<PlannedFit>::impossible("there are no trials");
  }
  const auto [structure, fit] = fitPlanned(model, trials, fitDesign);
  if (!fit) {
    return Estimable<PlannedFit>::impossible(fit.reason());
  }
  PlannedFit result = describe(model, trials, *fit);
  result.randomEffects = structure.effects;
  result.structure = structureText(structure.effects);
  result.leftOut = structure.reasons;
  finish(*fit, result);
  return result;
}

Eigen::VectorXd logarithmsOf(const std::vector<double>& seconds) {
  Eigen::VectorXd logarithms(static_cast<Eigen::Index>(seconds.size()));
  for (size_t i = 0; i < seconds.size(); ++i) {
    logarithms[static_cast<Eigen::Index>(i)] = std::log(seconds[i]);
  }
  return logarithms;
}

void addResiduals(const auto& fit, PlannedFit& result) {
  result.residuals.assign(fit.residuals.begin(), fit.residuals.end());
  result.residualDeviation = fit.residualDeviation;
}

}  // namespace

std::string labelOfTerm(const std::string& term) {
  static const std::map<std::string, std::string> kLabels{{"view", "view (@other@ / @reference@)"},
                                                          {"moving", "moving (yes / no)"},
                                                          {"duplicates", "colours (shared / different)"},
                                                          {"session", "session (each more)"},
                                                          {"exposure", "exposure (each second more)"},
                                                          {"objects", "objects (each more)"},
                                                          {"trial", "trial (each later)"}};
  const auto label = kLabels.find(term);
  if (label != kLabels.end()) {
    return label->second;
  }
  const size_t colon = term.find(':');
  return colon == std::string::npos ? term : fmt::format("{} x {}", term.substr(0, colon), term.substr(colon + 1));
}

std::string labelOfTerm(const PlannedModel& model, const std::string& term) {
  return model.kind == ModelKind::kSignedErrorMixed && term == "view" ? "view (@other@ against @reference@)"
                                                                      : labelOfTerm(term);
}

std::string measureOfTerm(const PlannedModel& model, const std::string& term, const TrialList& trials) {
  const ResponseScale& scale = responseScale(model, trials);
  const bool isHazard = model.kind == ModelKind::kCox;
  const char* one = isHazard ? "hazard ratio" : scale.one;
  const char* several = isHazard ? "hazard ratios" : scale.several;
  if (term.find(':') != std::string::npos) {
    return fmt::format("{} of {}, {}", scale.isRatio ? "ratio" : "difference", several, labelOfTerm(term));
  }
  return fmt::format("{}, {}", one,
                     term != "view"  ? labelOfTerm(term)
                     : scale.isRatio ? "@other@ / @reference@"
                                     : "@other@ less @reference@");
}

std::string columnOfTerm(const PlannedModel& model, const TrialList& trials, const std::string& term) {
  return columnOf(plannedColumns(model, trials, false), term);
}

TimeoutTreatment timesTreatmentOf(const PlannedModel& model, TimeoutTreatment planned) {
  const bool knowsCensored = model.kind == ModelKind::kLogNormalMixed;
  return planned == TimeoutTreatment::kCensored && !knowsCensored ? TimeoutTreatment::kSetToLimit : planned;
}

TrialList searchesOfMixedModel(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts) {
  TrialList searches = completeTrials(model, trials);
  std::erase_if(searches, [&](const Trial* trial) {
    const bool removed = timeouts == TimeoutTreatment::kRemoved && trial->censored.value_or(false);
    return removed || !trial->responseSeconds || *trial->responseSeconds <= 0;
  });
  return searches;
}

std::vector<double> secondsOf(const TrialList& trials) {
  std::vector<double> seconds;
  seconds.reserve(trials.size());
  for (const Trial* trial : trials) {
    seconds.push_back(*trial->responseSeconds);
  }
  return seconds;
}

Estimable<PlannedFit> fitValues(const PlannedModel& model, const TrialList& trials, const std::vector<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> response(values.data(), static_cast<Eigen::Index>(values.size()));
  return fitAndDescribe(
      model, trials, [&](Design design) { return LinearMixedModel(std::move(design)).fit(response); },
      [](const LinearMixedFit& fit, PlannedFit& result) { addResiduals(fit, result); });
}

Estimable<PlannedFit> fitLinear(const PlannedModel& model, const TrialList& trials,
                                const std::vector<double>& seconds) {
  const Eigen::VectorXd response = logarithmsOf(seconds);
  return fitAndDescribe(
      model, trials, [&](Design design) { return LinearMixedModel(std::move(design)).fit(response); },
      [](const LinearMixedFit& fit, PlannedFit& result) { addResiduals(fit, result); });
}

Estimable<PlannedFit> fitCensored(const PlannedModel& model, const TrialList& trials,
                                  const std::vector<double>& seconds, const std::vector<bool>& censored) {
  if (std::find(censored.begin(), censored.end(), true) == censored.end()) {
    return fitLinear(model, trials, seconds);
  }
  const CensoredResponse response{logarithmsOf(seconds), censored};
  return fitAndDescribe(
      model, trials, [&](Design design) { return CensoredMixedModel(std::move(design)).fitRestricted(response); },
      [](const CensoredMixedFit& fit, PlannedFit& result) { addResiduals(fit, result); });
}

Estimable<PlannedFit> fitTimes(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts) {
  if (timesTreatmentOf(model, timeouts) == TimeoutTreatment::kCensored) {
    std::vector<bool> censored;
    for (const Trial* trial : trials) {
      censored.push_back(trial->censored.value_or(false));
    }
    return fitCensored(model, trials, secondsOf(trials), censored);
  }
  return fitLinear(model, trials, secondsOf(trials));
}

Estimable<PlannedFit> fitBinomial(const PlannedModel& model, const TrialList& trials) {
  std::vector<bool> right;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false));
  }
  const BinomialResponse response = binaryResponse(right);
  return fitAndDescribe(
      model, trials, [&](Design design) { return BinomialMixedModel(std::move(design)).fitRestricted(response); },
      [](const BinomialMixedFit&, PlannedFit&) {});
}

Estimable<Estimate> viewLogarithm(const PlannedFit& fit) {
  const auto view =
      std::find_if(fit.terms.begin(), fit.terms.end(), [](const TermEstimate& term) { return term.term == "view"; });
  return view == fit.terms.end() ? Estimable<Estimate>::impossible("the model has no view") : view->estimate;
}

Estimable<Estimate> viewRatio(const Estimable<PlannedFit>& fit) {
  const Estimable<Estimate> view = fit ? viewLogarithm(*fit) : Estimable<Estimate>::impossible(fit.reason());
  return view ? Estimable<Estimate>(exponentiated(*view)) : view;
}

std::vector<Covariate> covariatesOf(const PlannedModel& model, const TrialList& trials) {
  const FixedEffects fixed = plannedColumns(model, trials, false);
  std::vector<Covariate> covariates;
  for (Eigen::Index i = 0; i < fixed.columns().cols(); ++i) {
    const auto column = fixed.columns().col(i);
    if (column.size() > 0 && column.maxCoeff() - column.minCoeff() > 1e-9) {
      covariates.push_back({fixed.names()[static_cast<size_t>(i)], {column.begin(), column.end()}});
    }
  }
  return covariates;
}

PlannedModel fittedModel(const PlannedModel& model, const PlannedFit& fit) {
  PlannedModel fitted = model;
  fitted.randomEffects = fit.randomEffects;
  return fitted;
}

std::string structureMethod(const PlannedModel& model, const PlannedFit& fit) {
  return fit.leftOut.empty()
             ? fit.structure
             : fmt::format("{}, those of {} that the data can tell", fit.structure, structureText(model.randomEffects));
}

void addPlannedFit(ReportWork& work, const PlannedModel& model, const TrialList& trials,
                   const Estimable<PlannedFit>& fit, const std::string& caption) {
  const ResponseScale& scale = responseScale(model, trials);
  for (const std::string& term : model.terms) {
    Estimable<double> pValue = Estimable<double>::impossible(fit ? "the term was dropped" : fit.reason());
    std::optional<TestedEffect> effect;
    if (fit) {
      for (const TermEstimate& estimate : fit->terms) {
        if (estimate.term == term && estimate.estimate) {
          pValue = estimate.estimate->pValue;
          effect = TestedEffect{measureOfTerm(model, term, trials), shownEffect(scale, *estimate.estimate)};
        }
      }
    }
    work.outcomes.push_back({model.name, term, pValue, effect});
  }
  if (!fit) {
    addNotEstimable(work.document, wordsOf(model), fit.reason());
    return;
  }
  const std::string source = fmt::format("model {} of {}", model.name, sizeText(trials));
  std::vector<EstimateRow> rows;
  for (const TermEstimate& term : fit->terms) {
    rows.push_back({labelOfTerm(model, term.term),
                    term.estimate ? Estimable<Estimate>(shownEffect(scale, *term.estimate)) : term.estimate,
                    scale.effectUnit, source, trials});
  }
  addEstimates(work.document, caption, model.name, rows);
  work.document.add(ReportParagraph{
      fmt::format("{}. Random effects as planned: {}; as fitted: {}. {}. As for the fit, {}.", sizeText(trials),
                  structureText(model.randomEffects), fit->structure, fmt::join(fit->random, "; "), fit->search)});
  for (const std::string& reason : fit->leftOut) {
    work.document.add(ReportNote{NoteKind::kNote, fmt::format("{}: {}.", wordsOf(model), reason)});
  }
  for (const std::string& warning : fit->warnings) {
    work.document.add(ReportNote{NoteKind::kWarning, fmt::format("{}: {}.", wordsOf(model), warning)});
  }
}

}  // namespace ocelli
