#include "analysis/report/report_task.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/dataset/protocol_facts.h"
#include "analysis/report/count_section.h"
#include "analysis/report/estimate_trials.h"
#include "analysis/report/find_section.h"
#include "analysis/report/other_task_section.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/path_section.h"
#include "analysis/report/survey_section.h"
#include "analysis/report/threshold_trials.h"

namespace ocelli {
namespace {

const ReportTask* findRow(const std::string& name) {
  const std::vector<ReportTask>& rows = reportTasks();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const ReportTask& each) { return each.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    names.push_back(name);
  }
}

}  // namespace

const std::vector<ReportTask>& reportTasks() {
  static const std::vector<ReportTask> kRows{findReportTask(), countReportTask(), pathReportTask(), surveyReportTask()};
  return kRows;
}

TaskMeasures taskMeasures(const TrialList& trials) {
  const bool sessions = std::any_of(trials.begin(), trials.end(),
                                    [&](const Trial* trial) { return trial->session != trials.front()->session; });
  return {unitOfEstimates(trials) != nullptr, hasLevels(trials), sessions};
}

ReportTask reportTask(const std::string& name, const TaskMeasures& measures) {
  const ReportTask* row = findRow(name);
  return row == nullptr ? otherTask(name, measures) : *row;
}

std::vector<std::string> tasksOfStudy(const Dataset& data) {
  std::vector<std::string> names;
  for (const DataSource& source : data.sources) {
    if (!source.protocolText.empty()) {
      for (const std::string& task : tasksOf(protocolFacts(source.protocolText, source.path))) {
        addOnce(names, task);
      }
    }
  }
  for (const Trial& trial : data.trials) {
    addOnce(names, trial.task);
  }
  return names;
}

std::vector<ReportTask> reportTasksOf(const Dataset& data, const AnalysisPlan& plan) {
  const std::vector<std::string> names = tasksOfStudy(data);
  std::vector<ReportTask> tasks;
  for (const ReportTask& row : reportTasks()) {
    const bool isPlanned = std::any_of(plan.models.begin(), plan.models.end(),
                                       [&](const PlannedModel& model) { return model.task == row.name; });
    if (!row.hasTrials || isPlanned || std::find(names.begin(), names.end(), row.name) != names.end()) {
      tasks.push_back(row);
    }
  }
  for (const Trial& trial : data.trials) {
    // A form has no trials: those of its name are a task that nobody knows.
    const ReportTask* row = findRow(trial.task);
    const bool isListed = std::any_of(
        tasks.begin(), tasks.end(), [&](const ReportTask& task) { return task.name == trial.task && task.hasTrials; });
    if (!isListed && (row == nullptr || !row->hasTrials)) {
      tasks.push_back(otherTask(trial.task, taskMeasures(trialsOfTask(data, trial.task))));
    }
  }
  return tasks;
}

std::vector<std::string> plannableTasks(const std::vector<std::string>& ofProtocol) {
  std::vector<std::string> names;
  for (const ReportTask& row : reportTasks()) {
    names.push_back(row.name);
  }
  for (const std::string& name : ofProtocol) {
    addOnce(names, name);
  }
  return names;
}

std::vector<std::string> plannableTasks(const Dataset& data) {
  return plannableTasks(tasksOfStudy(data));
}

const TaskModel* ReportTask::findModelKind(ModelKind kind) const {
  const auto found =
      std::find_if(modelKinds.begin(), modelKinds.end(), [&](const TaskModel& each) { return each.kind == kind; });
  return found == modelKinds.end() ? nullptr : &*found;
}

TimeoutTreatment ReportTask::timeouts(const AnalysisPlan& plan) const {
  return isTimed ? plan.findTimeouts : TimeoutTreatment::kCensored;
}

std::vector<PlannedModel> modelsOfTask(const AnalysisPlan& plan, const ReportTask& task) {
  std::vector<PlannedModel> models;
  std::copy_if(plan.models.begin(), plan.models.end(), std::back_inserter(models),
               [&](const PlannedModel& model) { return model.task == task.name; });
  return models.empty() && findRow(task.name) == nullptr ? task.models : models;
}

void addTaskModels(ReportWork& work, const ReportTask& task, const TrialList& trials) {
  for (const PlannedModel& model : modelsOfTask(work.analysis.plan, task)) {
    addPart(work, wordsOf(model), [&] {
      if (const TaskModel* kind = task.findModelKind(model.kind)) {
        kind->add(work, task, model, trials);
      } else {
        addNotEstimable(work.document, wordsOf(model),
                        fmt::format("{} is not done for {}", nameOf(model.kind), task.trialsName));
      }
    });
  }
}

namespace {

/// Of another number of conditions than two: the mixed models of the tasks, whose contrasts are those with the first
/// condition (contrast_weights.h).
AnalysisPlan defaultPlanOfConditions(const std::vector<std::string>& tasks) {
  AnalysisPlan plan;
  for (const ReportTask& task : reportTasks()) {
    if (task.hasTrials && !tasks.empty() && std::find(tasks.begin(), tasks.end(), task.name) == tasks.end()) {
      continue;
    }
    std::copy_if(task.models.begin(), task.models.end(), std::back_inserter(plan.models),
                 [](const PlannedModel& model) { return isMixed(model.kind) || model.kind == ModelKind::kOrdinal; });
  }
  return plan;
}

}  // namespace

AnalysisPlan defaultPlan(const ViewConditions& conditions, const std::vector<std::string>& tasks) {
  if (!conditions.isPair()) {
    return defaultPlanOfConditions(tasks);
  }
  AnalysisPlan plan;
  HypothesisFamily primary{"primary", true, {}};
  HypothesisFamily secondary{"secondary", true, {}};
  for (const ReportTask& task : reportTasks()) {
    if (task.hasTrials && !tasks.empty() && std::find(tasks.begin(), tasks.end(), task.name) == tasks.end()) {
      continue;
    }
    plan.models.insert(plan.models.end(), task.models.begin(), task.models.end());
    for (const TaskHypothesis& each : task.hypotheses) {
      plan.hypotheses.push_back(each.hypothesis);
      plan.hypotheses.back().statement = withViewLabels(each.hypothesis.statement, conditions);
      (each.primary ? primary : secondary).hypotheses.push_back(each.hypothesis.name);
    }
    if (task.equivalence) {
      plan.equivalence.push_back(*task.equivalence);
    }
  }
  for (const HypothesisFamily& family : {primary, secondary}) {
    if (!family.hypotheses.empty()) {
      plan.families.push_back(family);
    }
  }
  return plan;
}

}  // namespace ocelli
