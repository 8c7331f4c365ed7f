#include "analysis/report/conditions_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/holm.h"
#include "analysis/plot/forest_plot.h"
#include "analysis/plot/group_plot.h"
#include "analysis/report/measure_sections.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/response_scale.h"
#include "analysis/report/right_answers.h"
#include "analysis/report/subject_means.h"

namespace ocelli {
namespace {

std::string measureOf(const ResponseScale& scale, const PlannedContrast& contrast) {
  const std::string effect = contrast.levels.size() > 1
                                 ? fmt::format("{} of {}", scale.isRatio ? "ratio" : "difference", scale.several)
                                 : std::string(scale.one);
  return fmt::format("{}, {}", effect, comparisonText(contrast));
}

/// One condition after the other: the mean of subjects, with its interval.
void addMeans(ReportWork& work, const std::string& title, const std::string& id, const TrialValues& values,
              ValueScale scale) {
  const bool isTime = scale == ValueScale::kLogarithm;
  std::vector<EstimateRow> rows;
  GroupPlot plot;
  plot.title = title;
  plot.valueLabel = title;
  plot.summaryName = isTime ? "geometric mean, 95 % interval" : "mean, 95 % interval";
  plot.percent = scale == ValueScale::kShare;
  plot.rows = true;
  plot.legend = false;
  plot.series = {{"Conditions", {}}};
  for (const TrialView view : work.analysis.data.conditions.all()) {
    const SubjectNumbers means = subjectMeans(valuesOfView(values, view));
    rows.push_back(untested(
        rowOfSubjects(work.analysis.data.conditions.nameOf(view), means, scale, isTime ? "mean logarithms" : "means")));
    rows.back().unit = isTime ? "s" : "";
    if (!means.bySubject.empty()) {
      plot.conditions.push_back(labelOf(work, view));
      plot.series[0].groups.push_back(groupOfSubjects(means, scale));
    }
  }
  addEstimates(work.document,
               fmt::format("{} by condition: {} over the means of subjects, with 95 % intervals{}", title,
                           isTime ? "geometric means" : "means",
                           isTime ? "; trials whose time ran out count with the limit" : ""),
               id, rows);
  if (!plot.conditions.empty()) {
    addFigure(work, fmt::format("{} by condition: one dot a subject", title), fmt::format("figure-{}", id),
              [&] { return groupFigure(plot); });
  }
}

void addForest(ReportWork& work, const PlannedModel& model, const ResponseScale& scale,
               const std::vector<AskedContrast>& asked) {
  ForestPlot plot;
  plot.title = fmt::format("Contrasts of {}", model.name);
  plot.valueLabel = scale.axis;
  plot.lowerSide = scale.lowerSide;
  plot.upperSide = scale.upperSide;
  plot.ratio = scale.isRatio;
  for (const AskedContrast& each : asked) {
    ForestPlot::Row row{comparisonText(each.contrast)};
    if (each.effect) {
      row.interval = intervalOf(*each.effect);
    } else {
      row.reason = "cannot be estimated";
    }
    plot.rows.push_back(row);
  }
  addFigure(work, fmt::format("Contrasts of model {}, with 95 % intervals", model.name),
            fmt::format("figure-{}", contrastTableOf(model.name)), [&] { return forestFigure(plot); });
}

/// Of the model, in its own table, with p values as they are: families correct them.
void addContrastTable(ReportWork& work, const PlannedModel& model, const ResponseScale& scale, const TrialList& trials,
                      std::vector<AskedContrast>& asked) {
  std::vector<EstimateRow> rows;
  for (const AskedContrast& each : asked) {
    rows.push_back({comparisonText(each.contrast), each.effect, scale.effectUnit,
                    fmt::format("contrast of model {} of {}", model.name, sizeText(trials)), trials});
  }
  addEstimates(work.document,
               fmt::format("Contrasts of model {}: {}, with Satterthwaite's degrees of freedom; p values are not "
                           "corrected here",
                           model.name, scale.several),
               contrastTableOf(model.name), rows);
  if (work.document.origins.tables.empty() || work.document.origins.tables.back().name != contrastTableOf(model.name)) {
    return;
  }
  const Table& table = work.document.origins.tables.back();
  size_t row = 0;
  for (AskedContrast& each : asked) {
    if (!each.effect || row == table.rows.size()) {
      continue;
    }
    for (const Cell& cell : table.rows[row].cells) {
      each.cell = cell.name.ends_with("/p") ? cell.name : each.cell;
    }
    ++row;
  }
}

void addModelMeans(ReportWork& work, const PlannedModel& model, const ResponseScale& scale, const ConditionFit& fit) {
  std::vector<EstimateRow> rows;
  for (size_t i = 0; i < fit.means.size(); ++i) {
    Estimable<Estimate> mean = fit.means[i];
    if (mean) {
      mean = shownMean(scale, *mean);
    }
    rows.push_back({work.analysis.data.conditions.list[i].name, mean, scale.meanUnit,
                    fmt::format("marginal mean of model {} of {}", model.name, sizeText(fit.trials)), fit.trials});
  }
  addEstimates(
      work.document,
      fmt::format("Conditions by model {}: {} of a subject and a case without effects of their own, at the means "
                  "of other terms",
                  model.name, scale.meanName),
      fmt::format("{}-conditions", model.name), rows);
}

void addCovariates(ReportWork& work, const PlannedModel& model, const ResponseScale& scale, const ConditionFit& fit) {
  std::vector<EstimateRow> rows;
  for (const CovariateEstimate& each : fit.covariates) {
    rows.push_back({each.term, each.estimate ? Estimable<Estimate>(shownEffect(scale, *each.estimate)) : each.estimate,
                    scale.effectUnit, fmt::format("term of model {} of {}", model.name, sizeText(fit.trials)),
                    fit.trials});
  }
  if (!rows.empty()) {
    addEstimates(work.document,
                 fmt::format("Other terms of model {}, as {}: numbers of each unit more, factors of their second level "
                             "to their first",
                             model.name, scale.isRatio ? "ratios" : "differences"),
                 fmt::format("{}-terms", model.name), rows);
  }
}

/// What hypotheses of the plan ask for: terms with one column. In a study of a pair its own sections tell them.
void addOutcomes(ReportWork& work, const PlannedModel& model, const ResponseScale& scale,
                 const Estimable<ConditionFit>& fit) {
  if (work.analysis.data.conditions.isPair()) {
    return;
  }
  for (const std::string& term : model.terms) {
    TestOutcome outcome{model.name, term,
                        Estimable<double>::impossible(
                            fit ? fmt::format("the study has {} conditions, which contrasts of the plan compare",
                                              work.analysis.data.conditions.size())
                                : fit.reason())};
    for (size_t i = 0; fit && i < fit->covariates.size(); ++i) {
      const CovariateEstimate& each = fit->covariates[i];
      if (each.term == term && each.estimate) {
        outcome.pValue = each.estimate->pValue;
        outcome.effect = TestedEffect{fmt::format("{}, {}", scale.isRatio ? "ratio" : "difference", term),
                                      shownEffect(scale, *each.estimate)};
      }
    }
    work.outcomes.push_back(std::move(outcome));
  }
}

/// What a model is of, for the methods.
std::string methodOutcome(const ReportTask& task, const PlannedModel& model) {
  switch (modelOutcomeOf(model.kind)) {
    case ModelOutcome::kTimes:
      return "log " + task.timesOutcome;
    case ModelOutcome::kAnswers:
      return task.rightOutcome;
    case ModelOutcome::kEstimates:
      return fmt::format(
          "{} of {}", model.kind == ModelKind::kAbsoluteErrorMixed ? "logarithms of absolute errors" : "signed errors",
          task.trialsName);
  }
  return "";
}

void addConditionModel(ReportWork& work, const ReportTask& task, const PlannedModel& model,
                       ContrastFamilies& families) {
  const AnalysisData& analysis = work.analysis;
  const std::vector<PlannedContrast> contrasts = contrastsOf(analysis.plan, model, analysis.data.conditions);
  const TrialList trials = trialsOfTask(analysis, task.name);
  const ResponseScale& scale = responseScale(model, trials);
  std::vector<AskedContrast> asked;
  for (const PlannedContrast& contrast : contrasts) {
    asked.push_back({contrast, measureOf(scale, contrast)});
  }
  Estimable<ConditionFit> fit = Estimable<ConditionFit>::impossible("it was not fitted");
  addPart(work, wordsOf(model), [&] {
    fit = fitConditions(analysis.data, model, trials, task.timeouts(analysis.plan), contrasts);
    if (!fit) {
      addNotEstimable(work.document, wordsOf(model), fit.reason());
      for (AskedContrast& each : asked) {
        each.effect = Estimable<Estimate>::impossible(fit.reason());
      }
      return;
    }
    for (size_t i = 0; i < asked.size(); ++i) {
      const Estimable<Estimate>& estimate = fit->contrasts[i].estimate;
      asked[i].effect = estimate ? Estimable<Estimate>(shownEffect(scale, *estimate)) : estimate;
    }
    if (!asked.empty()) {
      addContrastTable(work, model, scale, fit->trials, asked);
      addForest(work, model, scale, asked);
    }
    addModelMeans(work, model, scale, *fit);
    addCovariates(work, model, scale, *fit);
    work.document.add(ReportParagraph{fmt::format(
        "{}. Random effects as planned: {}; as fitted: {}. {}. As for the fit, {}.", sizeText(fit->trials),
        conditionStructureText(model.randomEffects), fit->structure, fmt::join(fit->random, "; "), fit->search)});
    for (const std::string& reason : fit->leftOut) {
      work.document.add(ReportNote{NoteKind::kNote, fmt::format("{}: {}.", wordsOf(model), reason)});
    }
    for (const std::string& note : fit->notes) {
      work.document.add(ReportNote{NoteKind::kWarning, note});
    }
    for (const std::string& warning : fit->warnings) {
      work.document.add(ReportNote{NoteKind::kWarning, fmt::format("{}: {}.", wordsOf(model), warning)});
    }
    work.methods.push_back(
        fmt::format("Conditions were compared by contrasts of marginal means of the mixed model {} of {} with "
                    "Satterthwaite's degrees "
                    "of freedom; its random effects are {}.",
                    model.name, methodOutcome(task, model), fit->structure));
  });
  addOutcomes(work, model, scale, fit);
  for (AskedContrast& each : asked) {
    families.add(std::move(each));
  }
}

}  // namespace

std::string contrastTableOf(const std::string& model) {
  return fmt::format("{}-contrasts", model);
}

void addConditionTables(ReportWork& work, const ReportTask& task) {
  const TrialList trials = trialsOfTask(work.analysis, task.name);
  work.document.add(ReportParagraph{fmt::format("{}.", sizeText(trials))});
  TrialValues right;
  for (const Trial* trial : answeredTrials(trials)) {
    right.push_back({trial, trial->correct.value_or(false) ? 1.0 : 0.0});
  }
  TrialValues logarithms;
  for (const Trial* trial : trials) {
    if (trial->responseSeconds && *trial->responseSeconds > 0) {
      logarithms.push_back({trial, std::log(*trial->responseSeconds)});
    }
  }
  const std::string id = fmt::format("conditions-{}", namePart(task.name));
  if (right.empty()) {
    addNotEstimable(work.document, task.rightName, "no trial says whether its answer was right");
  } else {
    addMeans(work, task.rightName, fmt::format("{}-right", id), right, ValueScale::kShare);
  }
  if (logarithms.empty()) {
    addNotEstimable(work.document, task.timeName, "no trial has a time");
  } else {
    addMeans(work, task.timeName, fmt::format("{}-times", id), logarithms, ValueScale::kLogarithm);
  }
  addMeasureSections(work, task, trials);
}

void addConditionModels(ReportWork& work, const ReportTask& task, bool all, ContrastFamilies& families) {
  std::vector<std::string> others;
  for (const PlannedModel& model : modelsOfTask(work.analysis.plan, task)) {
    const std::vector<PlannedContrast>& contrasts = work.analysis.plan.contrasts;
    const bool hasContrasts = std::any_of(contrasts.begin(), contrasts.end(), [&](const PlannedContrast& contrast) {
      return contrast.model == model.name;
    });
    if (isMixed(model.kind) && (all || hasContrasts)) {
      addHeading(work.document, 2, fmt::format("Contrasts of {}", model.name),
                 fmt::format("contrasts-of-{}", model.name));
      addConditionModel(work, task, model, families);
    } else if (all) {
      others.push_back(model.name);
    }
  }
  if (!others.empty()) {
    work.document.add(ReportNote{
        NoteKind::kNote, fmt::format("Not done, as they compare two views: the models {}.", fmt::join(others, ", "))});
  }
}

void ContrastFamilies::write(ReportWork& work) const {
  std::vector<std::string> names;
  for (const AskedContrast& each : asked_) {
    if (std::find(names.begin(), names.end(), each.contrast.family) == names.end()) {
      names.push_back(each.contrast.family);
    }
  }
  for (const std::string& name : names) {
    std::vector<const AskedContrast*> members;
    std::vector<double> pValues;
    for (const AskedContrast& each : asked_) {
      if (each.contrast.family == name) {
        members.push_back(&each);
        pValues.push_back(each.effect ? each.effect->pValue : kNotKnown);
      }
    }
    const std::vector<double> adjusted = holmAdjusted(pValues);
    ReportTable table{
        fmt::format("Contrasts of family {}, corrected by Holm's method", name),
        fmt::format("family-{}", name),
        {{"Contrast", "", true}, {"Effect", "", true}, {"Estimate"}, {"95 % interval"}, {"p"}, {"Adjusted p"}},
        {}};
    OriginTable origins(work.document.origins, table.id, table.caption, {"p", "adjusted"});
    for (size_t i = 0; i < members.size(); ++i) {
      const AskedContrast& each = *members[i];
      const std::string source = fmt::format("p value of a contrast of model {}", each.contrast.model);
      const bool known = std::isfinite(pValues[i]);
      const std::string origin = known
                                     ? origins.addRow(each.contrast.name, source, {{}, Cell::From::kCells, {each.cell}},
                                                      "", {pValues[i], adjusted[i]})
                                     : "";
      const auto cell = [&](double p, const char* number) {
        ReportCell result{known ? pValueText(p) : std::string("-"),
                          origin.empty() ? "" : fmt::format("{}/{}", origin, number), known ? source : ""};
        if (known) {
          result.value = p;
        }
        return result;
      };
      ReportCell head{each.contrast.statement.empty() ? each.contrast.name : each.contrast.statement};
      head.shortName = each.contrast.name;
      ReportCell estimate{"-"};
      ReportCell interval{"-"};
      if (each.effect) {
        const EstimateTexts texts = textsOf(*each.effect);
        estimate.text = texts.value;
        estimate.value = each.effect->value;
        interval.text = texts.interval.empty() ? "-" : texts.interval;
        interval.interval = {each.effect->lower, each.effect->upper};
      } else {
        head.footnote = fmt::format("Cannot be estimated: {}.", each.effect.reason());
      }
      table.rows.push_back(
          {head, ReportCell{each.measure}, estimate, interval, cell(pValues[i], "p"), cell(adjusted[i], "adjusted")});
    }
    origins.finish();
    work.document.add(std::move(table));
  }
}

}  // namespace ocelli
