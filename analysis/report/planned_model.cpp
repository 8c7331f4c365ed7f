#include "analysis/report/planned_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

#include "analysis/models/binomial_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"

namespace ocelli {
namespace {

double numberOf(const Trial& trial, const std::string& term) {
  if (term == "session") {
    return trial.session;
  }
  if (term == "exposure") {
    return *trial.exposureSeconds;
  }
  return term == "objects" ? *trial.objects : trial.planIndex;
}

void addTerm(FixedEffects& fixed, const std::string& term, const TrialList& trials) {
  std::vector<std::string> labels;
  std::vector<double> numbers;
  double sum = 0;
  for (const Trial* trial : trials) {
    if (term == "view") {
      labels.push_back(nameOf(trial->view));
    } else if (term == "moving") {
      labels.push_back(*trial->moving ? "moving" : "stationary");
    } else if (term == "duplicates") {
      labels.push_back(*trial->duplicateColors ? "shared" : "different");
    } else {
      numbers.push_back(numberOf(*trial, term));
      sum += numbers.back();
    }
  }
  if (term == "view") {
    fixed.addFactor(term, labels, {"ppc", "gc"}, Coding::kCentered);
  } else if (term == "moving") {
    fixed.addFactor(term, labels, {"stationary", "moving"}, Coding::kCentered);
  } else if (term == "duplicates") {
    fixed.addFactor(term, labels, {"different", "shared"}, Coding::kCentered);
  } else {
    for (double& number : numbers) {
      number -= sum / static_cast<double>(trials.size());
    }
    fixed.addNumber(term, numbers);
  }
}

FixedEffects fixedEffects(const PlannedModel& model, const TrialList& trials, bool intercept) {
  FixedEffects fixed(static_cast<Eigen::Index>(trials.size()));
  if (intercept) {
    fixed.addIntercept();
  }
  for (const std::string& term : model.terms) {
    const size_t colon = term.find(':');
    if (colon == std::string::npos) {
      addTerm(fixed, term, trials);
    } else {
      fixed.addInteraction(term.substr(0, colon), term.substr(colon + 1));
    }
  }
  return fixed;
}

Design designOf(const PlannedModel& model, const TrialList& trials) {
  const FixedEffects fixed = fixedEffects(model, trials, true);
  std::vector<std::string> items;
  for (const Trial* trial : trials) {
    items.push_back(trial->item());
  }
  std::vector<RandomTerm> random;
  for (const RandomEffect& effect : model.randomEffects) {
    RandomTerm term = randomIntercepts(effect.group, effect.group == "subject" ? subjectsOf(trials) : items);
    for (const std::string& slope : effect.slopes) {
      addSlope(term, slope, fixed);
    }
    random.push_back(std::move(term));
  }
  return makeDesign(fixed, random);
}

std::string columnOf(const FixedEffects& fixed, const std::string& term) {
  const std::vector<Eigen::Index> columns = fixed.columnsOf(term);
  return columns.empty() ? "" : fixed.names()[static_cast<size_t>(columns.front())];
}

PlannedFit describe(const PlannedModel& model, const TrialList& trials, const MixedModelFit& fit) {
  PlannedFit result;
  const FixedEffects fixed = fixedEffects(model, trials, false);
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

constexpr const char* kNoTrials = "there are no trials";

}  // namespace

std::string labelOfTerm(const std::string& term) {
  static const std::map<std::string, std::string> kLabels{{"view", "view (gc / ppc)"},
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

std::string columnOfTerm(const PlannedModel& model, const TrialList& trials, const std::string& term) {
  return columnOf(fixedEffects(model, trials, false), term);
}

TrialList searchesOfLinearModel(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts) {
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

Estimable<PlannedFit> fitLinear(const PlannedModel& model, const TrialList& trials,
                                const std::vector<double>& seconds) {
  if (trials.empty()) {
    return Estimable<PlannedFit>::impossible(kNoTrials);
  }
  Eigen::VectorXd response(static_cast<Eigen::Index>(seconds.size()));
  for (size_t i = 0; i < seconds.size(); ++i) {
    response[static_cast<Eigen::Index>(i)] = std::log(seconds[i]);
  }
  const Estimable<LinearMixedFit> fit = LinearMixedModel(designOf(model, trials)).fit(response);
  if (!fit) {
    return Estimable<PlannedFit>::impossible(fit.reason());
  }
  PlannedFit result = describe(model, trials, *fit);
  result.residuals.assign(fit->residuals.begin(), fit->residuals.end());
  result.residualDeviation = fit->residualDeviation;
  return result;
}

Estimable<PlannedFit> fitBinomial(const PlannedModel& model, const TrialList& trials) {
  if (trials.empty()) {
    return Estimable<PlannedFit>::impossible(kNoTrials);
  }
  std::vector<bool> right;
  for (const Trial* trial : trials) {
    right.push_back(trial->correct.value_or(false));
  }
  const Estimable<BinomialMixedFit> fit =
      BinomialMixedModel(designOf(model, trials)).fitRestricted(binaryResponse(right));
  return fit ? Estimable<PlannedFit>(describe(model, trials, *fit)) : Estimable<PlannedFit>::impossible(fit.reason());
}

Estimable<Estimate> viewRatio(const Estimable<PlannedFit>& fit) {
  if (!fit) {
    return Estimable<Estimate>::impossible(fit.reason());
  }
  for (const TermEstimate& term : fit->terms) {
    if (term.term == "view") {
      return term.estimate ? Estimable<Estimate>(exponentiated(*term.estimate)) : term.estimate;
    }
  }
  return Estimable<Estimate>::impossible("the model has no view");
}

std::vector<Covariate> covariatesOf(const PlannedModel& model, const TrialList& trials) {
  const FixedEffects fixed = fixedEffects(model, trials, false);
  std::vector<Covariate> covariates;
  for (Eigen::Index i = 0; i < fixed.columns().cols(); ++i) {
    const auto column = fixed.columns().col(i);
    if (column.size() > 0 && column.maxCoeff() - column.minCoeff() > 1e-9) {
      covariates.push_back({fixed.names()[static_cast<size_t>(i)], {column.begin(), column.end()}});
    }
  }
  return covariates;
}

void addPlannedFit(ReportWork& work, const PlannedModel& model, const TrialList& trials,
                   const Estimable<PlannedFit>& fit, const std::string& caption) {
  for (const std::string& term : model.terms) {
    Estimable<double> pValue = Estimable<double>::impossible(fit ? "the term was dropped" : fit.reason());
    if (fit) {
      for (const TermEstimate& estimate : fit->terms) {
        if (estimate.term == term && estimate.estimate) {
          pValue = estimate.estimate->pValue;
        }
      }
    }
    work.outcomes.push_back({model.name, term, pValue});
  }
  if (!fit) {
    addNotEstimable(work.document, fmt::format("Model {}", model.name), fit.reason());
    return;
  }
  const std::string source = fmt::format("model {} of {}", model.name, sizeText(trials));
  std::vector<EstimateRow> rows;
  for (const TermEstimate& term : fit->terms) {
    rows.push_back({labelOfTerm(term.term),
                    term.estimate ? Estimable<Estimate>(exponentiated(*term.estimate)) : term.estimate, "", source,
                    trials});
  }
  addEstimates(work.document, caption, model.name, rows);
  work.document.add(ReportParagraph{fmt::format("{}. Random effects: {}. As for the fit, {}.", sizeText(trials),
                                                fmt::join(fit->random, "; "), fit->search)});
  for (const std::string& warning : fit->warnings) {
    work.document.add(ReportNote{NoteKind::kWarning, fmt::format("Model {}: {}.", model.name, warning)});
  }
}

}  // namespace ocelli
