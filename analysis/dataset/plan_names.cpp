#include <algorithm>
#include <array>

#include "analysis/dataset/analysis_plan.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

struct KindRow {
  ModelKind kind;
  const char* name;
  ModelOutcome outcome;
  bool isMixed;
};

constexpr std::array kKindRows{
    KindRow{ModelKind::kLinearMixed, "linear_mixed", ModelOutcome::kTimes, true},
    KindRow{ModelKind::kLogNormalMixed, "log_normal_mixed", ModelOutcome::kTimes, true},
    KindRow{ModelKind::kBinomialMixed, "binomial_mixed", ModelOutcome::kAnswers, true},
    KindRow{ModelKind::kKaplanMeier, "kaplan_meier", ModelOutcome::kTimes, false},
    KindRow{ModelKind::kCox, "cox", ModelOutcome::kTimes, false},
    KindRow{ModelKind::kLogNormalSurvival, "log_normal_survival", ModelOutcome::kTimes, false},
    KindRow{ModelKind::kMcNemar, "mcnemar", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kSignedError, "signed_error", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kEquivalence, "equivalence", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kBayesFactor, "bayes_factor", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kAgainstChance, "against_chance", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kOrdinal, "ordinal", ModelOutcome::kAnswers, false},
    KindRow{ModelKind::kSignedErrorMixed, "signed_error_mixed", ModelOutcome::kEstimates, true},
    KindRow{ModelKind::kAbsoluteErrorMixed, "absolute_error_mixed", ModelOutcome::kEstimates, true}};
static_assert(kKindRows.size() == std::size(kModelKinds), "each kind has a row");

const KindRow& rowOf(ModelKind kind) {
  const auto found =
      std::find_if(kKindRows.begin(), kKindRows.end(), [&](const KindRow& row) { return row.kind == kind; });
  OC_CHECK(found != kKindRows.end(), "each kind of model has a row");
  return *found;
}

}  // namespace

const char* nameOf(TimeoutTreatment treatment) {
  switch (treatment) {
    case TimeoutTreatment::kCensored:
      return "censored";
    case TimeoutTreatment::kRemoved:
      return "removed";
    case TimeoutTreatment::kSetToLimit:
      return "set_to_limit";
  }
  return "";
}

const char* nameOf(ModelKind kind) {
  return rowOf(kind).name;
}

ModelOutcome modelOutcomeOf(ModelKind kind) {
  return rowOf(kind).outcome;
}

bool isOfTimes(ModelKind kind) {
  return modelOutcomeOf(kind) == ModelOutcome::kTimes;
}

bool isMixed(ModelKind kind) {
  return rowOf(kind).isMixed;
}

}  // namespace ocelli
