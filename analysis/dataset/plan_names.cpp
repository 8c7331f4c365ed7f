#include "analysis/dataset/analysis_plan.h"

namespace ocelli {

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
  switch (kind) {
    case ModelKind::kLinearMixed:
      return "linear_mixed";
    case ModelKind::kLogNormalMixed:
      return "log_normal_mixed";
    case ModelKind::kBinomialMixed:
      return "binomial_mixed";
    case ModelKind::kKaplanMeier:
      return "kaplan_meier";
    case ModelKind::kCox:
      return "cox";
    case ModelKind::kLogNormalSurvival:
      return "log_normal_survival";
    case ModelKind::kMcNemar:
      return "mcnemar";
    case ModelKind::kSignedError:
      return "signed_error";
    case ModelKind::kEquivalence:
      return "equivalence";
    case ModelKind::kBayesFactor:
      return "bayes_factor";
    case ModelKind::kAgainstChance:
      return "against_chance";
    case ModelKind::kOrdinal:
      return "ordinal";
  }
  return "";
}

bool isOfTimes(ModelKind kind) {
  switch (kind) {
    case ModelKind::kLinearMixed:
    case ModelKind::kLogNormalMixed:
    case ModelKind::kKaplanMeier:
    case ModelKind::kCox:
    case ModelKind::kLogNormalSurvival:
      return true;
    case ModelKind::kBinomialMixed:
    case ModelKind::kMcNemar:
    case ModelKind::kSignedError:
    case ModelKind::kEquivalence:
    case ModelKind::kBayesFactor:
    case ModelKind::kAgainstChance:
    case ModelKind::kOrdinal:
      return false;
  }
  return false;
}

bool isMixed(ModelKind kind) {
  return kind == ModelKind::kLinearMixed || kind == ModelKind::kLogNormalMixed || kind == ModelKind::kBinomialMixed;
}

}  // namespace ocelli
