// What simulated studies told about how many subjects a study needs: the data of its report (power_report.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/base/estimate.h"
#include "analysis/dataset/analysis_plan.h"
#include "analysis/inference/power_curve.h"
#include "study/trial/estimated_value.h"
#include "study/trial/view_condition.h"

namespace ocelli {

/// Studies with one number of subjects.
struct PowerSize {
  int subjects = 0;             ///< that begin
  Share found;                  ///< of all studies: those with a result that is not estimable found nothing
  int notEstimable = 0;         ///< studies
  std::string reason{};         ///< why the first of these was not
  int warned = 0;               ///< studies whose fit is singular, did not converge, or lacks a column
  double analysed = 0;          ///< subjects that the plan's exclusions leave, mean
  double estimate = kNotKnown;  ///< mean of the studies: a ratio (geometric mean), or a difference of errors or shares
};

/// One test of studies of one kind.
struct PowerCurve {
  enum class Question {
    kPower,      ///< what is looked for is there
    kFalseAlarm  ///< it is not: the share of studies that find it nevertheless is the type-I error
  };
  enum class Test {
    kView,        ///< the views differ: the model's term "view", or a contrast
    kEquivalence  ///< they do not differ by as much as the plan's bounds
  };
  Question question = Question::kPower;
  Test test = Test::kView;
  std::string truth;       ///< "bent takes 0.8 of the time"
  std::string contrast{};  ///< that is tested in place of the view; empty in studies of two conditions
  double trueValue = 0;    ///< what `estimate` should be: a ratio or a difference
  std::vector<PowerSize> sizes;
};

struct PowerStudy {
  std::string protocolName;
  std::string protocolSha256;
  std::string task;
  ViewConditions conditions = defaultConditions();  ///< of the protocol
  AnalysisPlan plan;
  std::string model;                   ///< of the plan
  std::string contrast{};              ///< name of the one that is tested; empty: the model's term "view"
  const EstimateUnit* unit = nullptr;  ///< of answers that are estimates
  std::optional<PlannedEquivalence> bounds{};
  std::vector<std::string> supposed;  ///< what else was taken to be true, a line each
  int sessions = 1;
  double dropOut = 0;   ///< share of subjects who do not come back after a session
  int simulations = 0;  ///< studies of each number of subjects, of each kind
  double power = 0.8;
  double alpha = 0.05;
  uint64_t seed = 1;
  std::vector<PowerCurve> curves;
};

std::vector<PowerPoint> pointsOf(const PowerCurve& curve);

/// What estimates of the study are: "ratio of times", "odds ratio", "difference of signed errors".
std::string effectName(const PowerStudy& study);

/// "bent takes 0.8 of the time, test of the view".
std::string nameOf(const PowerCurve& curve);

/// The answer in a sentence: how many subjects reach the power, or how often studies find what is not there.
std::string answerOf(const PowerStudy& study, const PowerCurve& curve);

/// What a reader must be told besides: errors above alpha, studies without result, corrections that the plan makes.
std::vector<std::string> cautionsOf(const PowerStudy& study);

}  // namespace ocelli
