#include "analysis/report/other_task_section.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/error_model.h"
#include "analysis/report/measure_sections.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/right_model.h"
#include "analysis/report/share_models.h"
#include "analysis/report/subject_means.h"
#include "analysis/report/time_model.h"

namespace ocelli {
namespace {

/// The start of the names of its parts. No name of a row of the table starts so.
std::string idOf(const std::string& task) {
  return fmt::format("task-{}", namePart(task));
}

void addTimesByView(ReportWork& work, const ReportTask& task, const TrialList& trials) {
  TrialValues logarithms;
  for (const Trial* trial : trials) {
    if (trial->responseSeconds && *trial->responseSeconds > 0) {
      logarithms.push_back({trial, std::log(*trial->responseSeconds)});
    }
  }
  if (logarithms.empty()) {
    addNotEstimable(work.document, task.timeName, "no trial has a time");
    return;
  }
  ComparisonTable table;
  table.caption = fmt::format(
      "{}: geometric means over the geometric means of subjects with 95 % intervals; those whose time ran out count "
      "with the limit; subjects of @reference@, of @other@, and of both",
      task.timeName);
  table.id = fmt::format("{}-times", idOf(task.name));
  table.difference = "@other@ / @reference@";
  table.rows = {compareViews("All trials", logarithms, ValueScale::kLogarithm)};
  addComparison(work.document, table);
}

void addOtherTask(ReportWork& work, const ReportTask& task) {
  addHeading(work.document, 1, task.title, idOf(task.name));
  const TrialList trials = trialsOfTask(work.analysis, task.name);
  const AnalysisPlan& plan = work.analysis.plan;
  const bool isPlanned = std::any_of(plan.models.begin(), plan.models.end(),
                                     [&](const PlannedModel& model) { return model.task == task.name; });
  const TaskMeasures measures = taskMeasures(trials);
  const std::string described =
      fmt::format("right answers and times{}{}", measures.estimates ? ", and its estimates" : "",
                  measures.levels ? ", and the thresholds of its staircases" : "");
  work.document.add(ReportParagraph{
      fmt::format("{}. For this task Ocelli has no section of its own: it is described by {}{}.", sizeText(trials),
                  described, isPlanned ? "" : fmt::format(", with the usual models, as {} has none", planName(plan)))});
  const TrialList answered = answeredTrials(trials);
  if (answered.empty()) {
    addNotEstimable(work.document, task.rightName, "no trial says whether its answer was right");
  } else {
    addPart(work, "Answers that are right", [&] {
      addRightAnswers(work, answered, "Answers", fmt::format("{}-shares", idOf(task.name)), std::nullopt);
    });
  }
  addPart(work, "Times by view", [&] { addTimesByView(work, task, trials); });
  addMeasureSections(work, task, trials);
  addTaskModels(work, task, trials);
}

}  // namespace

ReportTask otherTask(const std::string& name, const TaskMeasures& measures) {
  const std::vector<RandomEffect> subjectAndCase{{"subject", {"view"}}, {"case", {"view"}}};
  ReportTask task;
  task.name = name;
  task.title = fmt::format("Task {}", name);
  task.trialsName = fmt::format("trials of {}", name);
  task.timesOutcome = fmt::format("times of {}", name);
  task.rightOutcome = fmt::format("right answers of {}", name);
  task.parts = {{task.title, fmt::format("task {}", name), 0.94, addOtherTask}};
  task.modelKinds = {{ModelKind::kBinomialMixed, addRightModel},      {ModelKind::kLogNormalMixed, addTimeModel},
                     {ModelKind::kLinearMixed, addTimeModel},         {ModelKind::kSignedErrorMixed, addErrorModel},
                     {ModelKind::kAbsoluteErrorMixed, addErrorModel}, {ModelKind::kEquivalence, addEquivalenceModel},
                     {ModelKind::kBayesFactor, addBayesModel}};
  const std::vector<std::string> terms =
      measures.sessions ? std::vector<std::string>{"view", "session"} : std::vector<std::string>{"view"};
  const auto add = [&](const char* what, ModelKind kind) {
    task.models.push_back({fmt::format("{}-{}", idOf(name), what), name, kind, terms, subjectAndCase});
  };
  if (measures.estimates) {
    add("signed-error", ModelKind::kSignedErrorMixed);
    add("absolute-error", ModelKind::kAbsoluteErrorMixed);
  } else if (!measures.levels) {
    add("right", ModelKind::kBinomialMixed);
  }
  add("time", ModelKind::kLogNormalMixed);
  return task;
}

}  // namespace ocelli
