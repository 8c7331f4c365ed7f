#include "analysis/power/contrast_effects.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "analysis/dataset/dataset.h"
#include "analysis/report/contrast_weights.h"
#include "oc_core/base/error.h"
#include "study/subject/generator_truth.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

void refuseOptionsOfPairs(const SupposedEffects& supposed) {
  const std::array<std::pair<const char*, bool>, 6> options{{{"--ratio", supposed.ratio.has_value()},
                                                             {"--difference", supposed.difference.has_value()},
                                                             {"--seconds-reference", supposed.secondsPpc.has_value()},
                                                             {"--odds-ratio", supposed.oddsRatio.has_value()},
                                                             {"--share-reference", supposed.sharePpc.has_value()},
                                                             {"--share-other", supposed.shareGc.has_value()}}};
  for (const auto& [name, isGiven] : options) {
    if (isGiven) {
      throw InputError("this option is for studies of two conditions", name,
                       "--effects FILE, with the effect of each condition (docs/simulated_subjects.md)");
    }
  }
  if (supposed.file.empty()) {
    throw InputError(
        "which effects of conditions are it that studies should find?", "--effects",
        R"(a file such as {"find": {"conditions": {"NAME": -0.3}}}, in log seconds, logits, or terms of errors)");
  }
}

/// By how much y of a condition is above that of the first.
double effectOf(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view) {
  return view == TrialView::kReference
             ? 0
             : effects.ofCondition(task, protocol.nameOf(view)).value_or(effects.at(task, kGraphEffect));
}

bool isOfDirections(const std::string& task) {
  const TaskKind& kind = taskKind(task, "--task");
  return kind.outcome == OutcomeKind::kEstimate && kind.generator.unit->isDirection;
}

/// What trials of a condition come to.
std::string trialsText(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task,
                       TrialView view) {
  const std::string& name = protocol.nameOf(view);
  switch (taskKind(task, "--task").outcome) {
    case OutcomeKind::kTime:
      return fmt::format("{}: trials take {:.3g} s (geometric mean, had they no limit)", name,
                         geometricMeanSeconds(protocol, effects, task, view));
    case OutcomeKind::kAnswer:
      return fmt::format("{}: {:.1f} % right", name, 100 * shareRight(protocol, effects, task, view));
    case OutcomeKind::kEstimate:
      break;
  }
  const double error = meanError(protocol, effects, task, view);
  return isOfDirections(task)
             ? fmt::format("{}: the mean signed error is {:.3g} degrees", name, error)
             : fmt::format("{}: estimates are {:.3g} of the truth (geometric mean)", name, std::exp(error));
}

}  // namespace

Truth contrastTruth(const Protocol& protocol, const SupposedEffects& supposed, const PlannedModel& model,
                    const PlannedContrast& contrast) {
  refuseOptionsOfPairs(supposed);
  Truth truth;
  truth.effects = readGeneratorEffects(supposed.file);
  checkConditions(truth.effects, protocol, supposed.file);
  const std::array<std::pair<const char*, std::optional<double>>, 5> deviations{
      {{kSubjectSd, supposed.subjectSd},
       {kSubjectGraphSd, supposed.subjectViewSd},
       {kItemSd, supposed.caseSd},
       {kItemViewSd, supposed.caseViewSd},
       {kResidualSd, supposed.residualSd}}};
  for (const auto& [name, value] : deviations) {
    if (value) {
      truth.effects.at(supposed.task, name) = *value;
    }
  }
  Dataset data;
  data.conditions = protocol.conditions.names;
  const ConditionTerms terms(data, model, {});
  const Estimable<std::vector<double>> weights = weightsOf(contrast, terms);
  if (!weights) {
    throw InputError(fmt::format("this contrast cannot be simulated: {}", weights.reason()), contrast.name,
                     "a contrast of conditions, or of factors that are crossed");
  }
  double sum = 0;
  for (size_t i = 0; i < weights->size(); ++i) {
    sum += (*weights)[i] * effectOf(protocol, truth.effects, supposed.task, conditionAt(terms.grid()[i].condition));
  }
  truth.conditions = protocol.conditions.names;
  truth.isDifference = isOfDirections(supposed.task);
  truth.effect = truth.isDifference ? sum : std::exp(sum);
  truth.reference = truth.isDifference ? 0 : 1;
  truth.other = truth.effect;
  truth.kind = std::abs(sum) < 1e-12 ? Truth::Kind::kNone : Truth::Kind::kWanted;
  truth.label = truth.kind == Truth::Kind::kNone ? fmt::format("no effect of {}", comparisonText(contrast))
                                                 : fmt::format("{} of {:.3g}", comparisonText(contrast), truth.effect);
  return truth;
}

Truth contrastTruthWithoutEffect(const Protocol& protocol, const std::string& task, const Truth& wanted) {
  Truth truth = wanted;
  truth.kind = Truth::Kind::kNone;
  for (const ViewCondition& condition : protocol.conditions.names.list) {
    truth.effects.setCondition(task, condition.name, 0);
  }
  truth.effect = truth.other = truth.isDifference ? 0 : 1;
  truth.label = "no difference of conditions";
  return truth;
}

std::vector<std::string> describeContrastTruth(const Protocol& protocol, const Truth& truth, const std::string& task) {
  const OutcomeKind outcome = taskKind(task, "--task").outcome;
  std::vector<std::string> lines;
  for (const TrialView view : protocol.conditions.names.all()) {
    lines.push_back(trialsText(protocol, truth.effects, task, view));
  }
  const double subjectViews = truth.effects.valueOr0(task, kSubjectGraphSd);
  lines.push_back(fmt::format("subjects differ in {} by {:.3g} (standard deviation), {}",
                              outcome == OutcomeKind::kTime     ? "log seconds"
                              : outcome == OutcomeKind::kAnswer ? "logits"
                              : truth.isDifference              ? "degrees of error"
                                                                : "log(estimate / truth)",
                              truth.effects.at(task, kSubjectSd),
                              subjectViews > 0
                                  ? fmt::format("and in the difference of two conditions by {:.3g}", subjectViews)
                                  : "with the same differences of conditions for all"));
  lines.push_back(fmt::format("cases differ by {:.3g}, and in the difference of two conditions by {:.3g}",
                              truth.effects.at(task, kItemSd), truth.effects.at(task, kItemViewSd)));
  if (outcome != OutcomeKind::kAnswer) {
    lines.push_back(
        fmt::format("trials of a subject for a case differ by {:.3g}", truth.effects.valueOr0(task, kResidualSd)));
  }
  return lines;
}

}  // namespace ocelli
