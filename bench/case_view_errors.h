// How often the tests of the default plan find an effect of the view that is not there, where cases differ in that
// effect: of its primary hypotheses, and of the survival models beside them. The mean effect over all cases that might
// have been shown is 0, so that a study of few cases that gain by chance must not count as an effect.
//
// Equivalence is tested where the views differ by just as much as the plan's bound: what is counted are studies that
// are called equivalent, and studies in which the one-sided test against that bound rejects.
#pragma once

#include <string>
#include <vector>

#include "bench/study_coverage.h"

namespace ocelli {

/// Who sees what.
struct ErrorDesign {
  std::string name;           ///< "8 x 12"
  std::vector<int> sessions;  ///< of each subject
  bool stationary = false;    ///< without the blocks of moving objects
};

/// 8 subjects in one session with stationary objects (12 searched places, 20 scenes, 10 paths); and the study of 2010.
ErrorDesign smallDesign();
ErrorDesign designOf2010();

struct ErrorScenario {
  std::string model;  ///< of the default plan
  ErrorDesign design;
  double ofItemViews = 0;  ///< log seconds or logits
};

/// Each test in both designs with deviations of 0, 0.2, 0.4 and 0.8.
std::vector<ErrorScenario> errorScenarios();

/// Throws std::logic_error for a model that is neither of a primary hypothesis nor of survival.
SimulatedStudy studyOf(const ErrorScenario& scenario, const Protocol& protocol);

struct ErrorRates {
  Share rejected{};          ///< p < 0.05, two-sided; of equivalence: called equivalent
  Share oneSided{};          ///< of equivalence alone: p < 0.05 against the bound at which the views differ
  int impossible = 0;        ///< studies without a p value
  int warned = 0;            ///< of mixed models: singular, not converged
  double deviation = 0;      ///< of the estimates over the studies
  double standardError = 0;  ///< root of the mean square of what was reported
};

/// Each study draws numbers of its own from the seed.
ErrorRates errorRatesOf(const ErrorScenario& scenario, const Protocol& protocol, const CoverageRun& run);

}  // namespace ocelli
