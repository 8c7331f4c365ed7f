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
  std::string name;            ///< "subject view=gc"
  std::vector<double> values;  ///< one a level
};

struct PlannedFit {
  std::vector<TermEstimate> terms;
  std::vector<std::string> warnings;  ///< singular, not converged, dropped columns
  std::vector<std::string> random;    ///< "subject: standard deviation 0.21"
  std::vector<double> fitted{};
  std::vector<double> residuals{};  ///< of a linear model
  double residualDeviation = 0;     ///< likewise
  std::vector<RandomEffectValues> effects{};
  std::string search;  ///< how the search for the optimum ended: a whole clause
};

/// What a fit says of "view", as a ratio. Impossible where the model has no view.
Estimable<Estimate> viewRatio(const Estimable<PlannedFit>& fit);

/// The searches that a linear model of log times takes: with all its terms, and a time above 0; without time-outs where
/// they are removed, and with the limit as the time of the others.
TrialList searchesOfLinearModel(const PlannedModel& model, const TrialList& trials, TimeoutTreatment timeouts);
std::vector<double> secondsOf(const TrialList& trials);

/// Of the logarithm of `seconds`, one a trial, all above 0. View and other factors are centered, numbers are less their
/// mean: each coefficient is that of an average trial.
Estimable<PlannedFit> fitLinear(const PlannedModel& model, const TrialList& trials, const std::vector<double>& seconds);
/// Of right answers; all trials know whether theirs was. By restricted likelihood, with t by Satterthwaite's degrees of
/// freedom: with few cases, Wald's intervals of maximum likelihood hold the truth too rarely (docs/results.md).
Estimable<PlannedFit> fitBinomial(const PlannedModel& model, const TrialList& trials);

/// The columns of the terms that vary at all.
std::vector<Covariate> covariatesOf(const PlannedModel& model, const TrialList& trials);

/// For the reader, as ratios are read: "view (gc / ppc)", "session (each more)", "view x session".
std::string labelOfTerm(const std::string& term);

/// The plan's term with that column; empty where there is none.
std::string columnOfTerm(const PlannedModel& model, const TrialList& trials, const std::string& term);

/// Adds a table of the terms (as ratios), with warnings, and keeps what hypotheses ask for.
void addPlannedFit(ReportWork& work, const PlannedModel& model, const TrialList& trials,
                   const Estimable<PlannedFit>& fit, const std::string& caption);

}  // namespace ocelli
