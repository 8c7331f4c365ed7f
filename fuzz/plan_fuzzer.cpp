// libFuzzer target: any bytes as a plan of an analysis. What is read is told, and applied to no data.
#include <cstdlib>
#include <string>

#include "analysis/dataset/exclusions.h"
#include "oc_core/base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const ocelli::AnalysisPlan plan =
        ocelli::planFromJsonText(std::string(data, data + size), "fuzz", {"find", "count", "path", "survey"});
    for (const ocelli::Hypothesis& hypothesis : plan.hypotheses) {
      if (plan.findModel(hypothesis.model) == nullptr) {
        std::abort();
      }
    }
    for (const ocelli::ExclusionRule& exclusion : plan.exclusions) {
      if (ocelli::describe(exclusion).empty()) {
        std::abort();
      }
    }
    if (!plan.isRegistered() || ocelli::describe(plan).empty()) {
      std::abort();
    }
    ocelli::applyPlan({}, plan);
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
