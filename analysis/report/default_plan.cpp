#include "analysis/report/default_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/report/report_parts.h"

namespace ocelli {
namespace {

bool isOfTables(const Dataset& data) {
  return std::all_of(data.sources.begin(), data.sources.end(),
                     [](const DataSource& source) { return source.form == DataSource::Form::kMappedTable; });
}

/// Models of forms, and what is asked of these.
void leaveOutForms(AnalysisPlan& plan) {
  std::set<std::string> forms;
  for (const ReportTask& row : reportTasks()) {
    if (!row.hasTrials) {
      forms.insert(row.name);
    }
  }
  const auto isOfForm = [&](const std::string& model) {
    const PlannedModel* found = plan.findModel(model);
    return found != nullptr && forms.contains(found->task);
  };
  for (HypothesisFamily& family : plan.families) {
    std::erase_if(family.hypotheses, [&](const std::string& name) {
      const Hypothesis* hypothesis = plan.findHypothesis(name);
      return hypothesis != nullptr && isOfForm(hypothesis->model);
    });
  }
  std::erase_if(plan.families, [](const HypothesisFamily& family) { return family.hypotheses.empty(); });
  std::erase_if(plan.hypotheses, [&](const Hypothesis& hypothesis) { return isOfForm(hypothesis.model); });
  std::erase_if(plan.models, [&](const PlannedModel& model) { return forms.contains(model.task); });
}

std::string testedOutcomeOf(const ReportTask& task, const PlannedModel& model) {
  switch (modelOutcomeOf(model.kind)) {
    case ModelOutcome::kTimes:
      return task.timesOutcome;
    case ModelOutcome::kAnswers:
      return task.rightOutcome;
    case ModelOutcome::kEstimates:
      return fmt::format("{} errors of {}", model.kind == ModelKind::kSignedErrorMixed ? "signed" : "absolute",
                         task.name);
  }
  return task.name;
}

bool canBeTested(const PlannedModel& model, const TrialList& trials) {
  return modelOutcomeOf(model.kind) != ModelOutcome::kAnswers ||
         std::any_of(trials.begin(), trials.end(), [](const Trial* trial) { return trial->correct.has_value(); });
}

}  // namespace

AnalysisPlan defaultPlanOf(const Dataset& data) {
  const std::vector<std::string> tasks = tasksOfStudy(data);
  AnalysisPlan plan = defaultPlan(data.conditions, tasks);
  if (!isOfTables(data) || !data.conditions.isPair()) {
    return plan;
  }
  leaveOutForms(plan);
  HypothesisFamily family{"views", true, {}};
  for (const ReportTask& task : reportTasksOf(data, plan)) {
    const bool isPlanned = std::any_of(plan.models.begin(), plan.models.end(),
                                       [&](const PlannedModel& model) { return model.task == task.name; });
    if (!task.hasTrials || isPlanned) {
      continue;
    }
    const TrialList trials = trialsOfTask(data, task.name);
    for (const PlannedModel& model : task.models) {
      plan.models.push_back(model);
      if (canBeTested(model, trials)) {
        std::string statement = fmt::format("The views differ in {}", testedOutcomeOf(task, model));
        plan.hypotheses.push_back({model.name, std::move(statement), model.name, "view"});
        family.hypotheses.push_back(model.name);
      }
    }
  }
  if (!family.hypotheses.empty()) {
    plan.families.push_back(std::move(family));
  }
  return plan;
}

}  // namespace ocelli
