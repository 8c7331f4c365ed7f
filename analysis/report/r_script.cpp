#include "analysis/report/r_script.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/report/estimate_trials.h"
#include "analysis/report/path_section.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/r_functions.h"
#include "analysis/report/report_parts.h"
#include "analysis/report/report_task.h"
#include "analysis/report/search_times.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

/// A string of R; JSON escapes what R does, in the same way.
std::string quoted(const std::string& text) {
  return nlohmann::json(cleanText(text)).dump();
}

std::string vectorOf(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) {
    all.push_back(quoted(text));
  }
  return fmt::format("c({})", fmt::join(all, ", "));
}

/// The functions with the names of the conditions; in names of R "-" becomes ".".
std::string functionsFor(const ViewConditions& conditions) {
  std::string text = kRFunctions;
  for (const TrialView view : kViews) {
    const std::string mark = fmt::format("_{}", markOf(view));
    std::string part = fmt::format("_{}", conditions.nameOf(view));
    std::replace(part.begin(), part.end(), '-', '.');
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + part.size())) {
      text.replace(at, mark.size(), part);
    }
  }
  return withViewNames(text, conditions);
}

/// Planned slopes by group: "list(subject = c("view"), case = character(0))".
std::string slopesOf(const PlannedModel& model) {
  std::vector<std::string> all;
  for (const RandomEffect& effect : model.randomEffects) {
    all.push_back(fmt::format("{} = {}", effect.group,
                              effect.slopes.empty() ? std::string("character(0)") : vectorOf(effect.slopes)));
  }
  return fmt::format("list({})", fmt::join(all, ", "));
}

std::string callOf(const AnalysisData& analysis, const PlannedModel& model) {
  const AnalysisPlan& plan = analysis.plan;
  const std::string name = quoted(model.name);
  const std::string trials = fmt::format("trials[trials$task == {}, ]", quoted(model.task));
  const std::string terms = vectorOf(model.terms);
  const std::string timeouts = quoted(nameOf(plan.findTimeouts));
  const char* cases = namesCases(model) ? "TRUE" : "FALSE";
  switch (model.kind) {
    case ModelKind::kLinearMixed:
    case ModelKind::kLogNormalMixed:
      return fmt::format("times_model({}, {}, {}, {}, {})", name, trials,
                         quoted(nameOf(timesTreatmentOf(model, plan.findTimeouts))), terms, slopesOf(model));
    case ModelKind::kBinomialMixed:
      return fmt::format("binomial_model({}, {}, {}, {})", name, trials, terms, slopesOf(model));
    case ModelKind::kKaplanMeier:
      return fmt::format("kaplan_meier({}, {}, {}, {})", name, trials, timeouts,
                         searchLimit(trialsOfTask(analysis, model.task)));
    case ModelKind::kCox:
      return fmt::format("cox_model({}, {}, {}, {}, {})", name, trials, timeouts, terms, cases);
    case ModelKind::kLogNormalSurvival:
      return fmt::format("log_normal_model({}, {}, {}, {}, {})", name, trials, timeouts, terms, cases);
    case ModelKind::kSignedErrorMixed:
    case ModelKind::kAbsoluteErrorMixed: {
      const EstimateUnit* unit = unitOfEstimates(trialsOfTask(analysis, model.task));
      return fmt::format("error_model({}, {}, {}, {}, {}, {})", name, trials, quoted(unit == nullptr ? "" : unit->name),
                         model.kind == ModelKind::kAbsoluteErrorMixed ? "TRUE" : "FALSE", terms, slopesOf(model));
    }
    case ModelKind::kMcNemar:
      return fmt::format("mcnemar_model({}, {})", name, trials);
    case ModelKind::kSignedError:
      return fmt::format("signed_error_model({}, {})", name, trials);
    case ModelKind::kEquivalence:
      for (const PlannedEquivalence& bounds : plan.equivalence) {
        if (bounds.task == model.task) {
          return fmt::format("equivalence_model({}, {}, {}, {}, {})", name, trials, bounds.lower, bounds.upper,
                             plan.alpha);
        }
      }
      return fmt::format("cat({}, \"the plan has no bounds\\n\")", name);
    case ModelKind::kBayesFactor:
      return fmt::format("bayes_model({}, {})", name, trials);
    case ModelKind::kAgainstChance:
      return fmt::format("chance_model({}, {}, {})", name, trials, chanceOf(analysis.data, model.task));
    case ModelKind::kOrdinal:
      return fmt::format("ordinal_model({}, answers)", name);
  }
  return "";
}

/// Those of the plan, and what the report does for tasks that it does not name.
std::vector<PlannedModel> modelsOf(const AnalysisData& analysis) {
  std::vector<PlannedModel> models = analysis.plan.models;
  for (const ReportTask& task : reportTasksOf(analysis.data, analysis.plan)) {
    for (const PlannedModel& model : modelsOfTask(analysis.plan, task)) {
      if (analysis.plan.findModel(model.name) == nullptr) {
        models.push_back(model);
      }
    }
  }
  return models;
}

std::string familyOf(const AnalysisPlan& plan, const HypothesisFamily& family, const std::set<std::string>& only) {
  std::vector<std::string> names;
  std::vector<std::string> models;
  std::vector<std::string> terms;
  for (const std::string& name : family.hypotheses) {
    const Hypothesis* hypothesis = plan.findHypothesis(name);
    const PlannedModel* model = hypothesis ? plan.findModel(hypothesis->model) : nullptr;
    if (model && (only.empty() || only.contains(model->task))) {
      names.push_back(name);
      models.push_back(hypothesis->model);
      terms.push_back(hypothesis->term);
    }
  }
  return names.empty()
             ? ""
             : fmt::format("family_of({}, {}, {}, {}, {}, {})\n", quoted(family.name), family.holm ? "TRUE" : "FALSE",
                           family.hypotheses.size(), vectorOf(names), vectorOf(models), vectorOf(terms));
}

}  // namespace

std::string rScript(const AnalysisData& analysis, const std::set<std::string>& only, const std::string& version) {
  std::string text =
      "# The models of the report once more, in R: Rscript analysis.R\n"
      "# It reads tables/trials.csv and tables/answers.csv beside it, and writes tables/r_results.csv.\n"
      "# Not repeated: resampling, effect sizes, sensitivity, intervals of restricted means, power laws, circular\n"
      "# statistics and thresholds.\n";
  text += functionsFor(analysis.data.conditions);
  text += fmt::format("\ncat({}, \"\\n\", {}, \"\\n\", {}, \"\\n\\n\", sep = \"\")\n", quoted("Ocelli " + version),
                      quoted(describe(analysis.plan)), quoted("SHA-256 of the data: " + analysis.dataSha256));
  text += "trials <- read(\"trials.csv\")\nanswers <- read(\"answers.csv\")\n\n";
  for (const PlannedModel& model : modelsOf(analysis)) {
    if (only.empty() || only.contains(model.task)) {
      text += callOf(analysis, model) + "\n";
    }
  }
  text += "\nprint(results, digits = 5)\n";
  for (const HypothesisFamily& family : analysis.plan.families) {
    text += familyOf(analysis.plan, family, only);
  }
  text += "write.csv(results, file.path(folder, \"tables\", \"r_results.csv\"), row.names = FALSE)\n";
  return text;
}

}  // namespace ocelli
