// How often what a report prints holds the truth, over simulated studies. Each study draws numbers of its own from the
// seed, so that nothing depends on the number of threads.
#pragma once

#include <cstdint>
#include <functional>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/inference/binomial_test.h"
#include "analysis/report/report_task.h"
#include "bench/simulated_study.h"

namespace ocelli {

/// Nominal level of each test, two-sided or one-sided.
inline constexpr double kAlpha = 0.05;

/// One line of a report's table.
struct ReportedTerm {
  std::string name;
  Estimate estimate;
};

struct StudyOutcome {
  std::vector<ReportedTerm> terms{};  ///< none: it could not be estimated
  bool singular = false;
  bool unconverged = false;
};

/// What a report does with the trials of a task, by the kind of the model.
StudyOutcome analyseStudy(const PlannedModel& model, const std::vector<Trial>& trials);

struct TermCoverage {
  std::string name;
  double truth = 0;
  int studies = 0;      ///< that have an interval or a p value
  Share covered{};      ///< of intervals
  Share coveredMean{};  ///< that hold the mean of the estimates, which is not the truth where a model does not fit
  Share rejected{};     ///< p < 0.05
  double meanError = 0;
  double deviation = 0;      ///< of the estimates over the studies
  double standardError = 0;  ///< root of the mean square of what was reported; not known where none was
};

struct CoverageResult {
  int studies = 0;
  int impossible = 0;
  int singular = 0;
  int unconverged = 0;
  std::vector<TermCoverage> terms{};
};

struct CoverageRun {
  int studies = 1000;
  uint64_t seed = 2010;
};

/// `truths`: of the terms, by their names in the report; others count as 0.
CoverageResult coverageOf(const PlannedModel& model, const SimulatedStudy& study,
                          const std::map<std::string, double>& truths, const CoverageRun& run);

/// A model of defaultPlan() with effects in truth, and the same without.
struct CoverageScenario {
  std::string name;   ///< "find-time"
  std::string model;  ///< of the plan
  std::string what;   ///< one line
  SimulatedTruth truth;
  bool balanced = false;  ///< views are counterbalanced over subjects; else as in the protocol
  bool slopes = false;    ///< a binomial model has slopes of the view by subject, whether the plan's has or not
};

std::vector<CoverageScenario> coverageScenarios();

/// The plan's, but for slopes of binomial models, which are the scenario's.
PlannedModel modelOf(const CoverageScenario& scenario);
SimulatedStudy studyOf(const CoverageScenario& scenario, const Protocol& protocol, bool null);
/// The terms' truths by the names that a report has for them.
std::map<std::string, double> reportedTruths(const CoverageScenario& scenario, const SimulatedStudy& study);

}  // namespace ocelli
