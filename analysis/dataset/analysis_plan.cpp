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
