#include "analysis/report/response_scale.h"

#include <cmath>

#include "analysis/report/estimate_trials.h"

namespace ocelli {
namespace {

using Means = ResponseScale::Means;

constexpr ResponseScale kTimes{"ratio of times",
                               "ratios of times",
                               "Ratio of times",
                               "faster",
                               "slower",
                               "geometric mean time",
                               "s",
                               "Fitted log seconds",
                               {},
                               true,
                               ""};
constexpr ResponseScale kAnswers{"odds ratio",
                                 "odds ratios",
                                 "Odds ratio",
                                 "fewer right",
                                 "more right",
                                 "probability of a right answer",
                                 "",
                                 "Fitted logit",
                                 Means::kProbability,
                                 true,
                                 ""};
constexpr ResponseScale kLengthErrors{"ratio of estimates",
                                      "ratios of estimates",
                                      "Ratio of estimates",
                                      "nearer",
                                      "farther",
                                      "geometric mean of estimate / truth",
                                      "",
                                      "Fitted log(estimate / truth)",
                                      Means::kExponential,
                                      true,
                                      ""};
constexpr ResponseScale kDirectionErrors{"difference of signed errors",
                                         "differences of signed errors",
                                         "Difference of signed errors (degrees)",
                                         "anticlockwise",
                                         "clockwise",
                                         "mean signed error",
                                         "degrees",
                                         "Fitted error (degrees)",
                                         Means::kPlain,
                                         false,
                                         "degrees"};
constexpr ResponseScale kAbsoluteErrors{"ratio of absolute errors",
                                        "ratios of absolute errors",
                                        "Ratio of absolute errors",
                                        "smaller errors",
                                        "larger errors",
                                        "geometric mean absolute error",
                                        "",
                                        "Fitted log absolute error",
                                        Means::kExponential,
                                        true,
                                        ""};
constexpr ResponseScale kAbsoluteDirectionErrors{"ratio of absolute errors",
                                                 "ratios of absolute errors",
                                                 "Ratio of absolute errors",
                                                 "smaller errors",
                                                 "larger errors",
                                                 "geometric mean absolute error",
                                                 "degrees",
                                                 "Fitted log absolute error",
                                                 Means::kExponential,
                                                 true,
                                                 ""};

}  // namespace

const ResponseScale& responseScale(const PlannedModel& model, const EstimateUnit* unit) {
  const bool isDirection = unit != nullptr && unit->isDirection;
  switch (modelOutcomeOf(model.kind)) {
    case ModelOutcome::kTimes:
      return kTimes;
    case ModelOutcome::kAnswers:
      return kAnswers;
    case ModelOutcome::kEstimates:
      break;
  }
  if (model.kind == ModelKind::kAbsoluteErrorMixed) {
    return isDirection ? kAbsoluteDirectionErrors : kAbsoluteErrors;
  }
  return isDirection ? kDirectionErrors : kLengthErrors;
}

const ResponseScale& responseScale(const PlannedModel& model, const TrialList& trials) {
  return responseScale(model,
                       modelOutcomeOf(model.kind) == ModelOutcome::kEstimates ? unitOfEstimates(trials) : nullptr);
}

Estimate shownEffect(const ResponseScale& scale, const Estimate& effect) {
  return scale.isRatio ? exponentiated(effect) : effect;
}

Estimate shownMean(const ResponseScale& scale, const Estimate& mean) {
  Estimate shown = scale.means == Means::kPlain ? mean : exponentiated(mean);
  if (scale.means == Means::kProbability) {
    const auto share = [](double logit) { return 1 / (1 + std::exp(-logit)); };
    shown.value = share(mean.value);
    shown.lower = share(mean.lower);
    shown.upper = share(mean.upper);
    shown.standardError = mean.standardError * shown.value * (1 - shown.value);
  }
  shown.statistic = shown.pValue = kNotKnown;
  return shown;
}

}  // namespace ocelli
