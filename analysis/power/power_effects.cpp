#include "analysis/power/power_effects.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/error.h"
#include "study/subject/generator_truth.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

constexpr double kMaxLogit = 20;  // beyond this the probability is 1 or 0 in practice

struct NamedOption {
  const char* name;
  const std::optional<double>& value;
};

void refuse(const std::vector<NamedOption>& options, const std::string& task, const char* instead) {
  for (const NamedOption& option : options) {
    if (option.value) {
      throw InputError(fmt::format("this option is not for --task {}", task), option.name, instead);
    }
  }
}

/// The value of `effect` for which `share()` is `wanted`: shares rise with it.
template <class Share>
void solve(double& effect, double wanted, const Share& share) {
  double low = -kMaxLogit;
  double high = kMaxLogit;
  for (int i = 0; i < 50; ++i) {
    effect = (low + high) / 2;
    (share() < wanted ? low : high) = effect;
  }
}

OutcomeKind outcomeOfTask(const std::string& task) {
  return taskKind(task, "--task").outcome;
}

/// Of a task whose answers are estimates.
const EstimateUnit& unitOf(const std::string& task) {
  return *taskKind(task, "--task").generator.unit;
}

/// How subjects, cases and trials differ: in what.
std::string spreadUnit(const std::string& task) {
  switch (outcomeOfTask(task)) {
    case OutcomeKind::kTime:
      return "log seconds";
    case OutcomeKind::kAnswer:
      return "logits";
    case OutcomeKind::kEstimate:
      return unitOf(task).isDirection ? "degrees of error" : "log(estimate / truth)";
  }
  return "";
}

/// Of the pinhole in the first session.
double& levelEffect(GeneratorEffects& effects, const std::string& task) {
  return effects.at(task, taskKind(task, "--task").generator.effects.front().name);
}

double& graphEffect(GeneratorEffects& effects, const std::string& task) {
  return effects.at(task, kGraphEffect);
}

/// Sets what was given.
void setDeviations(const SupposedEffects& supposed, GeneratorEffects& effects) {
  const std::array<std::pair<const char*, std::optional<double>>, 5> deviations{
      {{kSubjectSd, supposed.subjectSd},
       {kSubjectGraphSd, supposed.subjectViewSd},
       {kItemSd, supposed.caseSd},
       {kItemViewSd, supposed.caseViewSd},
       {kResidualSd, supposed.residualSd}}};
  constexpr double kMaxOfLogarithms = 5;
  const bool isDirection = outcomeOfTask(supposed.task) == OutcomeKind::kEstimate && unitOf(supposed.task).isDirection;
  for (const auto& [name, value] : deviations) {
    if (value && *value > kMaxOfLogarithms && !isDirection) {
      throw InputError(
          fmt::format("a standard deviation of {:g} is too large in {}", *value, spreadUnit(supposed.task)), name,
          "a number from 0 to 5");
    }
    if (value) {
      effects.at(supposed.task, name) = *value;
    }
  }
}

double level(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view) {
  switch (outcomeOfTask(task)) {
    case OutcomeKind::kTime:
      return geometricMeanSeconds(protocol, effects, task, view);
    case OutcomeKind::kAnswer:
      return shareRight(protocol, effects, task, view);
    case OutcomeKind::kEstimate:
      return meanError(protocol, effects, task, view);
  }
  return 0;
}

std::string sharesText(const Truth& truth) {
  return withViewNames(
      fmt::format("{:.1f} % right with @other@, {:.1f} % with @reference@", 100 * truth.other, 100 * truth.reference),
      truth.conditions);
}

std::string casesText(double itemSd, double itemViewSd) {
  return fmt::format("cases differ by {:.3g}, and {}", itemSd,
                     itemViewSd > 0 ? fmt::format("in the effect of the view by {:.3g}", itemViewSd)
                                    : "all have the same effect of the view: where yours do not, as where one view "
                                      "alone shows some objects, more cases are needed (--case-view-sd)");
}

std::string labelOf(const Truth& truth, const std::string& task) {
  if (truth.kind == Truth::Kind::kNone) {
    return "no effect of the view";
  }
  switch (outcomeOfTask(task)) {
    case OutcomeKind::kTime:
      return withViewNames(fmt::format("@other@ takes {:.3g} of the time", truth.effect), truth.conditions);
    case OutcomeKind::kAnswer:
      return sharesText(truth);
    case OutcomeKind::kEstimate:
      return withViewNames(
          unitOf(task).isDirection
              ? fmt::format("@other@ turns estimates by {:.3g} degrees", truth.effect)
              : fmt::format("estimates with @other@ are {:.3g} of those with @reference@", truth.effect),
          truth.conditions);
  }
  return "";
}

/// Fills in what follows from the effects.
void describe(const Protocol& protocol, const std::string& task, Truth& truth) {
  truth.conditions = protocolFacts(protocol.text, protocol.name).conditions;
  truth.isDifference = outcomeOfTask(task) == OutcomeKind::kEstimate && unitOf(task).isDirection;
  const double graph = graphEffect(truth.effects, task);
  truth.effect = truth.isDifference ? graph : std::exp(graph);
  truth.reference = level(protocol, truth.effects, task, TrialView::kReference);
  truth.other = level(protocol, truth.effects, task, TrialView::kOther);
  truth.label = labelOf(truth, task);
}

void setSearches(const Protocol& protocol, const SupposedEffects& supposed, GeneratorEffects& effects) {
  refuse({{"--odds-ratio", supposed.oddsRatio},
          {"--share-ppc", supposed.sharePpc},
          {"--share-gc", supposed.shareGc},
          {"--difference", supposed.difference}},
         supposed.task, "--ratio 0.8, of times");
  if (!supposed.ratio) {
    throw InputError("which effect is it that studies should find?", "--ratio",
                     "--ratio 0.8: searches with the graph camera take 0.8 of the time");
  }
  setDeviations(supposed, effects);
  graphEffect(effects, supposed.task) = std::log(*supposed.ratio);
  if (supposed.secondsPpc) {
    levelEffect(effects, supposed.task) +=
        std::log(*supposed.secondsPpc / geometricMeanSeconds(protocol, effects, supposed.task, TrialView::kReference));
  }
}

void setAnswers(const Protocol& protocol, const SupposedEffects& supposed, GeneratorEffects& effects) {
  refuse({{"--ratio", supposed.ratio},
          {"--difference", supposed.difference},
          {"--seconds-ppc", supposed.secondsPpc},
          {"--subject-view-sd", supposed.subjectViewSd},
          {"--residual-sd", supposed.residualSd}},
         supposed.task, "--share-ppc 0.6 --share-gc 0.7, or --odds-ratio 1.5");
  if (supposed.oddsRatio.has_value() == supposed.shareGc.has_value()) {
    throw InputError(supposed.oddsRatio ? "an odds ratio and a share both say what the effect is"
                                        : "which effect is it that studies should find?",
                     "--odds-ratio, --share-gc", "one of them: --odds-ratio 1.5, or --share-ppc 0.6 --share-gc 0.7");
  }
  setDeviations(supposed, effects);
  if (supposed.sharePpc) {
    solve(levelEffect(effects, supposed.task), *supposed.sharePpc,
          [&] { return shareRight(protocol, effects, supposed.task, TrialView::kReference); });
  }
  double& graph = graphEffect(effects, supposed.task);
  if (supposed.oddsRatio) {
    graph = std::log(*supposed.oddsRatio);
  } else if (supposed.shareGc == supposed.sharePpc) {
    graph = 0;
  } else {
    solve(graph, *supposed.shareGc, [&] { return shareRight(protocol, effects, supposed.task, TrialView::kOther); });
  }
}

void setEstimates(const SupposedEffects& supposed, GeneratorEffects& effects) {
  const bool isDirection = unitOf(supposed.task).isDirection;
  const char* instead = isDirection ? "--difference 10: degrees by which mean errors differ"
                                    : "--ratio 0.8: estimates with the other condition are 0.8 of those with the first";
  refuse({{"--odds-ratio", supposed.oddsRatio},
          {"--share-ppc", supposed.sharePpc},
          {"--share-gc", supposed.shareGc},
          {"--seconds-ppc", supposed.secondsPpc},
          {isDirection ? "--ratio" : "--difference", isDirection ? supposed.ratio : supposed.difference}},
         supposed.task, instead);
  const std::optional<double>& effect = isDirection ? supposed.difference : supposed.ratio;
  if (!effect) {
    throw InputError("which effect is it that studies should find?", isDirection ? "--difference" : "--ratio", instead);
  }
  setDeviations(supposed, effects);
  graphEffect(effects, supposed.task) = isDirection ? *effect : std::log(*effect);
}

}  // namespace

Truth wantedTruth(const Protocol& protocol, const SupposedEffects& supposed) {
  Truth truth;
  truth.effects = supposed.file.empty() ? GeneratorEffects{} : readGeneratorEffects(supposed.file);
  if (!truth.effects.ofConditions(supposed.task).empty()) {
    throw InputError("effects of conditions by their names are for contrasts", supposed.file,
                     "--contrast NAME; or the effect \"graph\" in the file, and options that say what it is");
  }
  switch (outcomeOfTask(supposed.task)) {
    case OutcomeKind::kTime:
      setSearches(protocol, supposed, truth.effects);
      break;
    case OutcomeKind::kAnswer:
      setAnswers(protocol, supposed, truth.effects);
      break;
    case OutcomeKind::kEstimate:
      setEstimates(supposed, truth.effects);
      break;
  }
  if (graphEffect(truth.effects, supposed.task) == 0) {
    truth.kind = Truth::Kind::kNone;
  }
  describe(protocol, supposed.task, truth);
  return truth;
}

Truth truthWithoutEffect(const Protocol& protocol, const std::string& task, const Truth& wanted) {
  Truth truth = wanted;
  truth.kind = Truth::Kind::kNone;
  graphEffect(truth.effects, task) = 0;
  describe(protocol, task, truth);
  return truth;
}

std::optional<Truth> truthAtBound(const Protocol& protocol, const Truth& wanted, const PlannedEquivalence& bounds) {
  constexpr double kEdge = 0.001;  // of shares, from 0 and 1
  double share = wanted.reference + bounds.upper;
  if (share > 1 - kEdge) {
    share = wanted.reference + bounds.lower;
  }
  if (share < kEdge) {
    return std::nullopt;
  }
  Truth truth = wanted;
  truth.kind = Truth::Kind::kAtBound;
  solve(graphEffect(truth.effects, bounds.task), share,
        [&] { return shareRight(protocol, truth.effects, bounds.task, TrialView::kOther); });
  describe(protocol, bounds.task, truth);
  return truth;
}

std::vector<std::string> describeTruth(const Truth& truth, const std::string& task) {
  const GeneratorEffects& effects = truth.effects;
  const OutcomeKind outcome = outcomeOfTask(task);
  const bool isOfAnswers = outcome == OutcomeKind::kAnswer;
  std::vector<std::string> lines;
  if (outcome == OutcomeKind::kEstimate) {
    lines.push_back(withViewLabels(
        truth.isDifference
            ? fmt::format("mean signed errors are {:.3g} degrees with the @reference@ and {:.3g} with the @other@",
                          truth.reference, truth.other)
            : fmt::format(
                  "estimates are {:.3g} of the truth with the @reference@ and {:.3g} with the @other@ (geometric "
                  "means)",
                  std::exp(truth.reference), std::exp(truth.other)),
        truth.conditions));
  } else if (!isOfAnswers) {
    lines.push_back(withViewLabels(
        fmt::format(
            "trials take {:.3g} s with the @reference@ and {:.3g} s with the @other@ (geometric means, had they "
            "no limit)",
            truth.reference, truth.other),
        truth.conditions));
  } else {
    lines.push_back(
        fmt::format("{}: an odds ratio of {:.3g} within a subject and case", sharesText(truth), truth.effect));
  }
  const double subjectGraphSd = effects.valueOr0(task, kSubjectGraphSd);
  lines.push_back(fmt::format(
      "subjects differ in {} by {:.3g} (standard deviation), {}", spreadUnit(task), effects.at(task, kSubjectSd),
      subjectGraphSd > 0 ? fmt::format("and in the effect of the view by {:.3g}", subjectGraphSd)
                         : "with the same effect of the view for all"));
  lines.push_back(casesText(effects.at(task, kItemSd), effects.at(task, kItemViewSd)));
  if (!isOfAnswers) {
    lines.push_back(
        fmt::format("trials of a subject for a case differ by {:.3g}", effects.valueOr0(task, kResidualSd)));
  }
  for (const GeneratorEffect& effect : taskKind(task, "--task").generator.effects) {
    const bool isToldAbove = effect.covariate == levelCovariate || effect.covariate == graphCovariate;
    if (effect.covariate != nullptr && !isToldAbove) {
      const double value = effects.at(task, effect.name);
      lines.push_back(truth.isDifference ? fmt::format("{}: errors are turned by {:.3g} degrees", effect.meaning, value)
                                         : fmt::format("{}: {} are multiplied by {:.3g}", effect.meaning,
                                                       isOfAnswers                         ? "odds"
                                                       : outcome == OutcomeKind::kEstimate ? "estimates"
                                                                                           : "times",
                                                       std::exp(value)));
    }
  }
  return lines;
}

}  // namespace ocelli
