#include "cli/power_effects.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/dataset/protocol_facts.h"
#include "oc_core/base/error.h"
#include "study/subject/generator_truth.h"

namespace ocelli {
namespace {

constexpr double kMaxLogit = 20;  // more is as good as always

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

void set(double& effect, const std::optional<double>& value) {
  effect = value.value_or(effect);
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

double& graphEffect(GeneratorEffects& effects, const std::string& task) {
  return task == "find" ? effects.find.graph : task == "count" ? effects.count.graph : effects.path.graph;
}

double level(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, StudyView view) {
  return task == "find" ? geometricMeanSeconds(protocol, effects, view) : shareRight(protocol, effects, task, view);
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

/// Fills in what follows from the effects.
void describe(const Protocol& protocol, const std::string& task, Truth& truth) {
  truth.conditions = protocolFacts(protocol.text, protocol.name).conditions;
  truth.ratio = std::exp(graphEffect(truth.effects, task));
  truth.reference = level(protocol, truth.effects, task, StudyView::kPinhole);
  truth.other = level(protocol, truth.effects, task, StudyView::kGraph);
  truth.label = truth.kind == Truth::Kind::kNone ? "no effect of the view"
                : task == "find"
                    ? withViewNames(fmt::format("@other@ takes {:.3g} of the time", truth.ratio), truth.conditions)
                    : sharesText(truth);
}

void setSearches(const Protocol& protocol, const SupposedEffects& supposed, GeneratorEffects& effects) {
  refuse({{"--odds-ratio", supposed.oddsRatio}, {"--share-ppc", supposed.sharePpc}, {"--share-gc", supposed.shareGc}},
         supposed.task, "--ratio 0.8, of times");
  if (!supposed.ratio) {
    throw InputError("which effect is it that studies should find?", "--ratio",
                     "--ratio 0.8: searches with the graph camera take 0.8 of the time");
  }
  GeneratorEffects::Find& find = effects.find;
  set(find.subjectSd, supposed.subjectSd);
  set(find.subjectGraphSd, supposed.subjectViewSd);
  set(find.itemSd, supposed.caseSd);
  set(find.itemViewSd, supposed.caseViewSd);
  set(find.residualSd, supposed.residualSd);
  find.graph = std::log(*supposed.ratio);
  if (supposed.secondsPpc) {
    find.logSeconds += std::log(*supposed.secondsPpc / geometricMeanSeconds(protocol, effects, StudyView::kPinhole));
  }
}

void setAnswers(const Protocol& protocol, const SupposedEffects& supposed, GeneratorEffects& effects) {
  refuse({{"--ratio", supposed.ratio},
          {"--seconds-ppc", supposed.secondsPpc},
          {"--subject-view-sd", supposed.subjectViewSd},
          {"--residual-sd", supposed.residualSd}},
         supposed.task, "--share-ppc 0.6 --share-gc 0.7, or --odds-ratio 1.5");
  if (supposed.oddsRatio.has_value() == supposed.shareGc.has_value()) {
    throw InputError(supposed.oddsRatio ? "an odds ratio and a share both say what the effect is"
                                        : "which effect is it that studies should find?",
                     "--odds-ratio, --share-gc", "one of them: --odds-ratio 1.5, or --share-ppc 0.6 --share-gc 0.7");
  }
  const bool isCount = supposed.task == "count";
  double& right = isCount ? effects.count.right : effects.path.right;
  set(isCount ? effects.count.subjectSd : effects.path.subjectSd, supposed.subjectSd);
  set(isCount ? effects.count.itemSd : effects.path.itemSd, supposed.caseSd);
  set(isCount ? effects.count.itemViewSd : effects.path.itemViewSd, supposed.caseViewSd);
  if (supposed.sharePpc) {
    solve(right, *supposed.sharePpc, [&] { return shareRight(protocol, effects, supposed.task, StudyView::kPinhole); });
  }
  double& graph = graphEffect(effects, supposed.task);
  if (supposed.oddsRatio) {
    graph = std::log(*supposed.oddsRatio);
  } else if (supposed.shareGc == supposed.sharePpc) {
    graph = 0;
  } else {
    solve(graph, *supposed.shareGc, [&] { return shareRight(protocol, effects, supposed.task, StudyView::kGraph); });
  }
}

}  // namespace

Truth wantedTruth(const Protocol& protocol, const SupposedEffects& supposed) {
  Truth truth;
  truth.effects = supposed.file.empty() ? GeneratorEffects{} : readGeneratorEffects(supposed.file);
  if (supposed.task == "find") {
    setSearches(protocol, supposed, truth.effects);
  } else {
    setAnswers(protocol, supposed, truth.effects);
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
        [&] { return shareRight(protocol, truth.effects, bounds.task, StudyView::kGraph); });
  describe(protocol, bounds.task, truth);
  return truth;
}

std::vector<std::string> describeTruth(const Truth& truth, const std::string& task) {
  const GeneratorEffects& effects = truth.effects;
  if (task == "find") {
    const GeneratorEffects::Find& find = effects.find;
    return {
        withViewLabels(
            fmt::format("searches take {:.3g} s with the @reference@ and {:.3g} s with the @other@ (geometric "
                        "means, had they no limit)",
                        truth.reference, truth.other),
            truth.conditions),
        fmt::format(
            "subjects differ in log seconds by {:.3g} (standard deviation), and in the effect of the view by {:.3g}",
            find.subjectSd, find.subjectGraphSd),
        casesText(find.itemSd, find.itemViewSd),
        fmt::format("searches of a subject for a case differ by {:.3g}", find.residualSd),
        fmt::format("moving objects multiply times by {:.3g}, each further session by {:.3g}", std::exp(find.moving),
                    std::exp(find.session))};
  }
  const bool isCount = task == "count";
  std::vector<std::string> lines{
      fmt::format("{}: an odds ratio of {:.3g} within a subject and case", sharesText(truth), truth.ratio),
      fmt::format("subjects differ in logits by {:.3g} (standard deviation), with the same effect of the view for all",
                  isCount ? effects.count.subjectSd : effects.path.subjectSd),
      isCount ? casesText(effects.count.itemSd, effects.count.itemViewSd)
              : casesText(effects.path.itemSd, effects.path.itemViewSd),
      fmt::format("each further session multiplies odds by {:.3g}",
                  std::exp(isCount ? effects.count.session : effects.path.session))};
  if (isCount) {
    lines.push_back(fmt::format("duplicate colours multiply odds by {:.3g}, twice the exposure by {:.3g}",
                                std::exp(effects.count.duplicates), std::exp(effects.count.doubledExposure)));
  }
  return lines;
}

}  // namespace ocelli
