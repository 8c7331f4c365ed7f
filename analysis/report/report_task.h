// The tasks of a study as its report knows them: a row each, which owns all that is done for the task. No other file
// asks for a task by its name.
//
// A task of a database that has no row is reported nevertheless, by reportTask(): right answers and times by view, with
// the usual models (other_task_section.h).
//
// Recipe for a section of its own for a task:
//   1. analysis/report/NAME_section.h and .cpp: the section, and `ReportTask NAMEReportTask()`, which says what is
//   below.
//   2. analysis/report/report_task.cpp: its line in reportTasks().
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/exclusions.h"
#include "analysis/tables/table_cells.h"

namespace ocelli {

struct ReportTask;
struct ReportWork;

/// A part of the report with its heading.
struct TaskPart {
  std::string title;    ///< for a note where the part fails
  std::string stage{};  ///< for the progress of the work; empty: it takes no time
  double done = 0;      ///< how much of the work of a study with all tasks is done before it, 0 to 1
  void (*add)(ReportWork& work, const ReportTask& task) = nullptr;
};

/// How a model of a plan is fitted and shown; `trials` are those of the section.
struct TaskModel {
  ModelKind kind = ModelKind::kBinomialMixed;
  void (*add)(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& trials) = nullptr;
};

struct TaskHypothesis {
  Hypothesis hypothesis;  ///< its statement may hold marks of view conditions
  bool primary = false;   ///< of the family "primary", or else of "secondary"
};

struct ReportTask {
  std::string name;          ///< as databases, protocols and plans have it: "find"
  std::string title;         ///< "Finding"
  std::string trialsName;    ///< "searches"
  std::string timesOutcome;  ///< what models of times are of: "times to find"
  std::string rightOutcome;  ///< what models of right answers are of: "right counts"
  std::string timeName = "Time to answer (s)";
  std::string rightName = "Share of right answers";
  bool isTimed = false;   ///< its outcome is the time, and the plan's "find_timeouts" says how time-outs count
  bool hasTrials = true;  ///< or else it is a form
  std::vector<TaskPart> parts{};
  std::vector<TaskModel> modelKinds{};
  // What is done where nobody registered a plan.
  std::vector<PlannedModel> models{};
  std::vector<TaskHypothesis> hypotheses{};
  std::optional<PlannedEquivalence> equivalence{};

  /// nullptr where models of the kind are not done for the task.
  const TaskModel* findModelKind(ModelKind kind) const;
  TimeoutTreatment timeouts(const AnalysisPlan& plan) const;
};

/// The rows, in the order of the report.
const std::vector<ReportTask>& reportTasks();
/// What trials of a task tell beside right answers and times, which decides what is done with a task without a row.
struct TaskMeasures {
  bool estimates = false;  ///< answers that are numbers (study/trial/estimated_value.h)
  bool levels = false;     ///< of the stimulus: the measure "level"
  bool sessions = false;   ///< they are of more than one
};
TaskMeasures taskMeasures(const TrialList& trials);

/// The row of the name, or what is done for a task without one.
ReportTask reportTask(const std::string& name, const TaskMeasures& measures = {});
/// The tasks that the study has, as its protocols say, or its trials where there are none.
std::vector<std::string> tasksOfStudy(const Dataset& data);
/// The rows that the study or the plan has, forms, and the tasks of trials that have no row.
std::vector<ReportTask> reportTasksOf(const Dataset& data, const AnalysisPlan& plan);

/// What a plan may name as "task": the rows, and what the protocols and trials have. The list is what readPlan() takes.
std::vector<std::string> plannableTasks(const Dataset& data);
std::vector<std::string> plannableTasks(const std::vector<std::string>& ofProtocol);

/// The plan's models of the task; those of the task itself where it has no row and the plan does not name it.
std::vector<PlannedModel> modelsOfTask(const AnalysisPlan& plan, const ReportTask& task);
/// Fits and shows them one after the other; a note says so of a kind that is not done for the task.
void addTaskModels(ReportWork& work, const ReportTask& task, const TrialList& trials);

/// What is done where nobody registered a plan: the protocol's own exclusions, time-outs as censored, and the models
/// and hypotheses of the rows, which are those of protocols/rosen2010.plan.json. Of `tasks` alone, and of forms, where
/// there are some: what a study does not have is no hypothesis of it.
AnalysisPlan defaultPlan(const ViewConditions& conditions = defaultConditions(),
                         const std::vector<std::string>& tasks = {});

}  // namespace ocelli
