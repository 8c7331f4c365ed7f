#include "analysis/dataset/analysis_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace ocelli {
namespace {

template <class Named>
const Named* findByName(const std::vector<Named>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Named& each) { return each.name == name; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace

const PlannedModel* AnalysisPlan::findModel(const std::string& model) const {
  return findByName(models, model);
}

const Hypothesis* AnalysisPlan::findHypothesis(const std::string& hypothesis) const {
  return findByName(hypotheses, hypothesis);
}

AnalysisPlan defaultPlan() {
  const std::vector<RandomEffect> subjectAndCase{{"subject", {"view"}}, {"case", {"view"}}};
  AnalysisPlan plan;
  plan.models = {
      {"find-time",
       "find",
       ModelKind::kLogNormalMixed,
       {"view", "session", "moving", "view:session", "view:moving"},
       subjectAndCase},
      {"find-survival", "find", ModelKind::kKaplanMeier},
      {"find-hazard", "find", ModelKind::kCox, {"view", "session", "moving"}, {{"subject"}, {"case"}}},
      {"find-log-normal",
       "find",
       ModelKind::kLogNormalSurvival,
       {"view", "session", "moving"},
       {{"subject"}, {"case"}}},
      {"count-right",
       "count",
       ModelKind::kBinomialMixed,
       {"view", "exposure", "duplicates", "session", "moving"},
       subjectAndCase},
      {"count-matched", "count", ModelKind::kMcNemar},
      {"count-error", "count", ModelKind::kSignedError},
      {"path-right", "path", ModelKind::kBinomialMixed, {"view", "session"}, subjectAndCase},
      {"path-equivalence", "path", ModelKind::kEquivalence},
      {"path-bayes", "path", ModelKind::kBayesFactor},
      {"path-chance", "path", ModelKind::kAgainstChance},
      {"survey", "survey", ModelKind::kOrdinal},
  };
  plan.hypotheses = {
      {"find-faster", "Objects are found in another time with the graph camera than with the pinhole", "find-time",
       "view"},
      {"find-learning", "Sessions change the times of the two views differently", "find-time", "view:session"},
      {"count-better", "Counts are right more or less often with the graph camera than with pinholes", "count-right",
       "view"},
      {"path-alike", "Paths are recognised equally well in both views", "path-equivalence", ""},
      {"path-above-chance", "Paths are recognised more often than by guessing", "path-chance", ""},
      {"survey-preference", "One of the views is said to be easier", "survey", ""},
  };
  plan.families = {{"primary", true, {"find-faster", "count-better", "path-alike"}},
                   {"secondary", true, {"find-learning", "path-above-chance", "survey-preference"}}};
  plan.equivalence = {{"path", -0.1, 0.1}};
  return plan;
}

std::string describe(const AnalysisPlan& plan) {
  if (!plan.isRegistered()) {
    return "no plan was registered: what is done are the defaults of Ocelli, not decisions made before the data were "
           "seen";
  }
  return fmt::format("plan \"{}\", {}, SHA-256 {}", plan.name,
                     plan.registered.empty() ? "which does not say where it was registered"
                                             : fmt::format("registered: {}", plan.registered),
                     plan.sha256);
}

}  // namespace ocelli
