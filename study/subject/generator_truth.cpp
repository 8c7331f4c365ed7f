#include "study/subject/generator_truth.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "study/protocol/schedule.h"
#include "study/tasks/task_registry.h"

namespace ocelli {
namespace {

/// As of slot 0: who comes first changes orders alone.
std::vector<GeneratedTrial> trialsOf(const Protocol& protocol, const std::string& task, TrialView view) {
  std::vector<GeneratedTrial> trials;
  for (int session = 1; session <= protocol.sessions; ++session) {
    for (const TrialPlan& plan : scheduleOf(protocol, 0, session, protocol.seed).trials) {
      if (plan.task == task) {
        const TaskBlock& block = *protocol.blocks[static_cast<size_t>(plan.block)].task;
        trials.push_back({task, view, block.caseInfo(plan.caseIndex), session, protocol.nameOf(view)});
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

/// Over all trials of the task.
double meanFixedPart(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task,
                     TrialView view) {
  const std::vector<GeneratedTrial> trials = trialsOf(protocol, task, view);
  double sum = 0;
  for (const GeneratedTrial& trial : trials) {
    sum += fixedPart(effects, trial);
  }
  return sum / static_cast<double>(trials.size());
}

}  // namespace

double geometricMeanSeconds(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task,
                            TrialView view) {
  OC_CHECK(taskKind(task, protocol.name).outcome == OutcomeKind::kTime, "the outcome of the task is a time");
  return std::exp(meanFixedPart(protocol, effects, task, view));
}

double meanError(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view) {
  OC_CHECK(taskKind(task, protocol.name).outcome == OutcomeKind::kEstimate, "the outcome of the task is an estimate");
  return meanFixedPart(protocol, effects, task, view);
}

double shareRight(const Protocol& protocol, const GeneratorEffects& effects, const std::string& task, TrialView view) {
  OC_CHECK(taskKind(task, protocol.name).outcome == OutcomeKind::kAnswer, "the outcome of the task is an answer");
  // Of a pair half of it counts for each view; of other numbers of conditions each draws its own (generator_model.h).
  const double share = protocol.conditions.names.isPair() ? 0.5 : 1 / std::numbers::sqrt2;
  const double deviation =
      std::hypot(effects.at(task, kSubjectSd), effects.at(task, kItemSd), effects.at(task, kItemViewSd) * share);
  const std::vector<GeneratedTrial> trials = trialsOf(protocol, task, view);
  double sum = 0;
  for (const GeneratedTrial& trial : trials) {
    sum += meanProbability(fixedPart(effects, trial), deviation);
  }
  return sum / static_cast<double>(trials.size());
}

}  // namespace ocelli
