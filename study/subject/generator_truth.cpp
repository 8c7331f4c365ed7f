#include "study/subject/generator_truth.h"

#include <fmt/format.h>

#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// As of slot 0: who comes first changes orders alone.
std::vector<GeneratedTrial> trialsOf(const Protocol& protocol, const std::string& task, StudyView view) {
  std::vector<GeneratedTrial> trials;
  for (int session = 0; session < protocol.sessions; ++session) {
    for (const TrialPlan& plan : scheduleOf(protocol, 0, session, protocol.seed).trials) {
      if (plan.task == task) {
        const TaskBlock& block = *protocol.blocks[static_cast<size_t>(plan.block)].task;
        trials.push_back({task, view, block.caseInfo(plan.caseIndex), session});
      }
    }
  }
  if (trials.empty()) {
    throw InputError(fmt::format("protocol {} has no block with the task {}", protocol.name, task),
                     protocol.file.empty() ? protocol.name : protocol.file.string(),
                     "a task that it has, or another protocol");
  }
  return trials;
}

/// The mean of 1 / (1 + exp(-logit)) over a normal logit: a sum over a fine grid, whose error is far below 1e-6.
double meanProbability(double logit, double deviation) {
  constexpr double kEnd = 8;  // standard deviations
  constexpr int kSteps = 160;
  double sum = 0;
  double weights = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double z = kEnd * (2.0 * i / kSteps - 1);
    const double weight = std::exp(-z * z / 2);
    sum += weight / (1 + std::exp(-(logit + deviation * z)));
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

double fixedPart(const GeneratorEffects& effects, const GeneratedTrial& trial) {
  const double graph = trial.view == StudyView::kGraph ? 1 : 0;
  const CaseInfo& info = trial.info;
  if (trial.task == "find") {
    const GeneratorEffects::Find& find = effects.find;
    return find.logSeconds + find.graph * graph + (info.moving ? find.moving : 0) + find.session * trial.session;
  }
  if (trial.task == "count") {
    const GeneratorEffects::Count& count = effects.count;
    return count.right + count.graph * graph + (info.duplicateColors.value_or(false) ? count.duplicates : 0) +
           count.doubledExposure * std::log2(info.exposureSeconds.value_or(10) / 10) + count.session * trial.session;
  }
  return effects.path.right + effects.path.graph * graph + effects.path.session * trial.session;
}

double geometricMeanSeconds(const Protocol& protocol, const GeneratorEffects& effects, StudyView view) {
  const std::vector<GeneratedTrial> trials = trialsOf(protocol, "find", view);
  double sum = 0;
  for (const GeneratedTrial& trial : trials) {
    sum += fixedPart(effects, trial);
  }
  return std::exp(sum / static_cast<double>(trials.size()));
}

double shareRight(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, StudyView view) {
  const bool isCount = task == "count";
  const auto deviationOf = [](const auto& group) {
    return std::hypot(group.subjectSd, group.itemSd, group.itemViewSd / 2);
  };
  const double deviation = isCount ? deviationOf(effects.count) : deviationOf(effects.path);
  const std::vector<GeneratedTrial> trials = trialsOf(protocol, task, view);
  double sum = 0;
  for (const GeneratedTrial& trial : trials) {
    sum += meanProbability(fixedPart(effects, trial), deviation);
  }
  return sum / static_cast<double>(trials.size());
}

}  // namespace ocelli
