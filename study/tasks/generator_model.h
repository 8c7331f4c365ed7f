// What the data-only subject (study/subject/data_generator.h) knows of a task: the effects on its outcomes, as named
// numbers.
//
//   y = sum of effect * covariate(trial), over the fixed effects
//       + subject + subjectGraph * [gc] + item + itemView * ([gc] - 1/2)     of a pair of conditions, "gc" the other
//       + subject + subjectCondition + item + itemCondition                  of other numbers of conditions
//
// y is the mean of log seconds, the logit of a right answer, or the mean of the signed error of an estimate in the
// terms of its unit (task_registry.h, OutcomeKind); of log seconds and of errors there is a residual too. The last four
// and the residual are normal with mean 0. Items are the cases of a block in a session, the same for all subjects.
// "itemView" is by how much the effect of the view on an item differs from the mean effect; half of it counts for each
// view, so that without an effect of the view times and shares of all items are the same in both views. Of other
// numbers of conditions each subject, and each item, draws a number for each condition, with the deviations
// subject_graph_sd and item_view_sd over the square root of 2: two conditions differ by as much as in a pair.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/task.h"
#include "study/trial/estimated_value.h"

namespace ocelli {

/// A trial as far as effects ask for it.
struct GeneratedTrial {
  std::string task;
  TrialView view = TrialView::kReference;
  CaseInfo info;
  int session = 1;          ///< from 1
  std::string condition{};  ///< its name; where it is empty, effects that were set by names do not count
};

struct GeneratorEffect {
  const char* name;  ///< in JSON
  double value;      ///< where none is given; made up: nothing is known of people by it
  const char* meaning;
  /// What a fixed effect is multiplied by; nothing for a standard deviation.
  double (*covariate)(const GeneratedTrial& trial) = nullptr;
};

// Names that mean the same in all tasks. A model without "subject_graph_sd" or "residual_sd" draws no such numbers.
inline constexpr const char* kGraphEffect = "graph";
inline constexpr const char* kSubjectSd = "subject_sd";
inline constexpr const char* kSubjectGraphSd = "subject_graph_sd";
inline constexpr const char* kItemSd = "item_sd";
inline constexpr const char* kItemViewSd = "item_view_sd";
inline constexpr const char* kResidualSd = "residual_sd";

struct GeneratorModel {
  /// In the order of their sum. The first is the level: y of the pinhole in the first session. All models have
  /// "graph", "subject_sd", "item_sd" and "item_view_sd".
  std::vector<GeneratorEffect> effects;
  /// Another answer than the one expected, which is empty where the generator does not tell answers. None for tasks
  /// whose outcome is a time or an estimate.
  std::string (*wrongAnswer)(const std::string& expected, Random& random) = nullptr;
  /// Of tasks whose outcome is an estimate, in what; what is expected is a number then.
  const EstimateUnit* unit = nullptr;
  /// Of these: how large the signed error of a right answer may be, either way.
  double rightWithin = 0;
  /// Stands in the record of each simulated subject, whether its protocol has the task or not: as databases have it
  /// that are older than the registry. New tasks leave it.
  bool recordedAlways = false;

  /// Index of an effect; nothing where the model has none of this name.
  std::optional<size_t> indexOf(std::string_view name) const;
};

double levelCovariate(const GeneratedTrial& trial);    ///< 1
double graphCovariate(const GeneratedTrial& trial);    ///< 0 in the reference, else 1
double sessionCovariate(const GeneratedTrial& trial);  ///< sessions before

}  // namespace ocelli
