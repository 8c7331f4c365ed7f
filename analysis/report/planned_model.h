// The models of a plan as the rooms of statistics want them.
#pragma once

#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/inference/covariate.h"
#include "analysis/report/report_parts.h"

namespace ocelli {

/// What a fit says of the terms that the plan names.
struct TermEstimate {
  std::string term;  ///< of the plan
  std::string column;
  Estimable<Estimate> estimate;  ///< on the model's own scale: log seconds, logits
};

/// Predictions of one random effect.
struct RandomEffectValues {
  std::string name;            ///< "subject view=other"
  std::vector<double> values;  ///< one a level
};

struct PlannedFit {
  std::vector<TermEstimate> terms;
  std::vector<std::string> warnings;  ///< singular, not converged, dropped columns
  std::vector<std::string> random;    ///< "subject: standard deviation 0.21"
  std::vector<double> fitted{};
  std::vector<double> residuals{};  ///< of times; of a censored one, the mean of what is expected above it
  double residualDeviation = 0;     ///< likewise
  std::vector<RandomEffectValues> effects{};
  std::string search{};                       ///< how the search for the optimum ended: a whole clause
  std::vector<RandomEffect> randomEffects{};  ///< that were fitted
  std::string structure{};                    ///< the same in words, "(1 + view || subject) + (1 | case)"
  std::vector<std::string> leftOut{};         ///< what of the planned ones was left out and why: whole clauses
};

/// What a fit says of "view", on the model's own scale and as a ratio. Impossible where the model has no view.
Estimable<Estimate> viewLogarithm(const PlannedFit& fit);
Estimable<Estimate> viewRatio(const Estimable<PlannedFit>& fit);

/// What models of the kind can do: a linear one takes censored times as if the search had ended at the limit.
TimeoutTreatment timesTreatmentOf(const PlannedModel& model, TimeoutTreatment planned);
/// The searches that a mixed model of log times takes: with all its terms, and a time above 0; without time-outs where
/// they are removed.
TrialList searchesOfMixedModel(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts);
std::vector<double> secondsOf(const TrialList& trials);

// Random effects are the planned ones as far as the data tell them: planned_design.h.

/// Of the logarithm of `seconds`, one a trial, all above 0. View and other factors are centered, numbers are less their
/// mean: each coefficient is that of an average trial.
Estimable<PlannedFit> fitLinear(const PlannedModel& model, const TrialList& trials, const std::vector<double>& seconds);
/// Likewise, where the `censored` ones would have taken longer. Where none is, this is fitLinear().
Estimable<PlannedFit> fitCensored(const PlannedModel& model, const TrialList& trials,
                                  const std::vector<double>& seconds, const std::vector<bool>& censored);
/// Of searchesOfMixedModel(): what the plan's kind of model and treatment of time-outs ask for. A linear model counts
/// censored times as they are.
Estimable<PlannedFit> fitTimes(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts);
/// Of `values`, one a trial, as they are.
Estimable<PlannedFit> fitValues(const PlannedModel& model, const TrialList& trials, const std::vector<double>& values);
/// Of right answers; all trials know whether theirs was. By restricted likelihood, with t by Satterthwaite's degrees of
/// freedom: with few cases, Wald's intervals of maximum likelihood hold the truth too rarely (docs/results.md).
Estimable<PlannedFit> fitBinomial(const PlannedModel& model, const TrialList& trials);

/// The columns of the terms that vary at all.
std::vector<Covariate> covariatesOf(const PlannedModel& model, const TrialList& trials);

/// For the reader, as ratios are read: "view (other / reference)", "session (each more)", "view x session".
std::string labelOfTerm(const std::string& term);
/// Of signed errors, whose effects may be differences: "view (other against reference)".
std::string labelOfTerm(const PlannedModel& model, const std::string& term);

/// What the effect of a term is of: "ratio of times, other / reference", "odds ratio, session (each more)". `trials`:
/// of the model, whose estimates have a unit.
std::string measureOfTerm(const PlannedModel& model, const std::string& term, const TrialList& trials = {});

/// The plan's term with that column; empty where there is none.
std::string columnOfTerm(const PlannedModel& model, const TrialList& trials, const std::string& term);

/// The model with the random effects that were fitted, for other choices of trials: what was left out stays out.
PlannedModel fittedModel(const PlannedModel& model, const PlannedFit& fit);
inline constexpr const char* kFittedModelNote =
    "Random effects are those of the main analysis, as far as the trials tell them.";

/// For the methods: "(1 + view || subject) + (1 | case), those of ... that the data can tell".
std::string structureMethod(const PlannedModel& model, const PlannedFit& fit);

/// Adds a table of the terms (as response_scale.h has it), with warnings, and keeps what hypotheses ask for.
void addPlannedFit(ReportWork& work, const PlannedModel& model, const TrialList& trials,
                   const Estimable<PlannedFit>& fit, const std::string& caption);

}  // namespace ocelli
