// What a power analysis supposes to be true, from a user's terms to effects of the data-only subject.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/analysis_plan.h"
#include "study/protocol/protocol.h"
#include "study/subject/generator_effects.h"
#include "study/trial/view_condition.h"

namespace ocelli {

/// What the user gave; what is missing is the generator's.
struct SupposedEffects {
  std::string task;  ///< its name (study/tasks/task_registry.h)
  std::string file;  ///< JSON of effects, as of `ocelli study simulate --effects`; the others come on top of it
  std::optional<double> ratio{};       ///< of geometric mean times, or of estimates of lengths, gc / ppc
  std::optional<double> difference{};  ///< of mean errors of directions, gc less ppc, degrees
  std::optional<double> secondsPpc{};  ///< geometric mean time with the pinhole
  std::optional<double> oddsRatio{};   ///< of right answers, gc to ppc, of a subject and case
  std::optional<double> sharePpc{};    ///< of right answers
  std::optional<double> shareGc{};
  // Standard deviations, in log seconds, logits, or terms of errors (study/trial/estimated_value.h).
  std::optional<double> subjectSd{};
  std::optional<double> subjectViewSd{};
  std::optional<double> caseSd{};
  std::optional<double> caseViewSd{};
  std::optional<double> residualSd{};
};

struct Truth {
  enum class Kind {
    kWanted,
    kNone,     ///< the views do not differ
    kAtBound,  ///< they differ by a bound of equivalence
  };
  Kind kind = Kind::kWanted;
  std::string label;            ///< "bent takes 0.8 of the time"
  GeneratorEffects effects;     ///< of all tasks; only those of the task matter
  ViewConditions conditions{};  ///< of the protocol: the reference is that of --share-ppc, the other that of --share-gc
  double effect = 1;  ///< of times, odds or lengths the ratio of the other to the reference; of directions, degrees
  bool isDifference = false;  ///< of directions: no effect is 0
  /// Geometric mean seconds without a limit, share of right answers, or mean signed error.
  double reference = 0;
  double other = 0;
};

/// The effect that is wanted. Throws InputError for options of other tasks, for those that are missing or contradict
/// each other, and for a protocol without the task.
Truth wantedTruth(const Protocol& protocol, const SupposedEffects& supposed);
/// The same without a difference of the views: with the pinhole as it is.
Truth truthWithoutEffect(const Protocol& protocol, const std::string& task, const Truth& wanted);
/// The same with a difference of shares that is just as large as equivalence allows: the upper bound, or the lower one
/// where shares end before. Nothing where neither is possible.
std::optional<Truth> truthAtBound(const Protocol& protocol, const Truth& wanted, const PlannedEquivalence& bounds);

/// All that is supposed in lines for a reader: levels of both views, how subjects and cases differ, other effects.
std::vector<std::string> describeTruth(const Truth& truth, const std::string& task);

}  // namespace ocelli
