#include "analysis/report/study_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "analysis/dataset/form_item.h"
#include "analysis/dataset/protocol_facts.h"
#include "analysis/report/apparatus_section.h"
#include "analysis/report/completers_section.h"
#include "analysis/report/condition_terms.h"
#include "analysis/report/conditions_section.h"
#include "analysis/report/flow_section.h"
#include "analysis/report/learning_section.h"
#include "analysis/report/methods_section.h"
#include "analysis/report/paper_section.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/provenance_section.h"
#include "analysis/report/questionnaire_section.h"
#include "analysis/report/r_script.h"
#include "analysis/report/report_task.h"
#include "analysis/report/speed_accuracy_section.h"
#include "analysis/report/view_words.h"
#include "oc_core/base/csv.h"
#include "study/trial/estimated_value.h"
#include "study/trial/level_measures.h"

namespace ocelli {
namespace {

/// Of another number of conditions than two.
void addConditionsOfDesign(ReportWork& work) {
  const ViewConditions& conditions = work.analysis.data.conditions;
  ReportList list;
  for (const ViewCondition& condition : conditions.list) {
    std::vector<std::string> levels;
    for (const auto& [factor, level] : condition.levels) {
      levels.push_back(fmt::format("{} {}", factor, level));
    }
    list.items.push_back(levels.empty()
                             ? fmt::format("{}: {}", condition.name, condition.label)
                             : fmt::format("{}: {} ({})", condition.name, condition.label, fmt::join(levels, ", ")));
  }
  work.document.add(ReportParagraph{
      fmt::format("The study has {} condition{}:", conditions.size(), conditions.size() == 1 ? "" : "s")});
  work.document.add(list);
  work.document.add(ReportParagraph{
      "Intervals are of 95 %; tests and intervals of ratios are of their logarithm, and SE is the standard error, of "
      "ratios by the delta method. Contrasts compare conditions, or levels of factors with the other factors at their "
      "means, each cell counting alike; their p values are corrected by Holm's method within their family. Tables that "
      "are marked as exploratory are not of a registered plan."});
  work.document.add(ReportNote{
      NoteKind::kNote,
      "Left out, as they compare two views: the tables of Rosen 2010, learning by view, navigation, the comparison of "
      "completers and drop-outs, resampling, sizes of effects, sensitivity to cases, checks of residuals, and "
      "analysis.R."});
}

void addDesign(ReportWork& work) {
  const AnalysisData& analysis = work.analysis;
  addHeading(work.document, 1, "Design and data", "design");
  for (const DataSource& source : analysis.data.sources) {
    if (!source.protocolText.empty()) {
      const ProtocolFacts protocol = protocolFacts(source.protocolText, source.path);
      work.document.add(ReportParagraph{fmt::format("{}. {}", protocol.title, protocol.description)});
      ReportList blocks;
      for (const ProtocolBlockFacts& block : protocol.blocks) {
        blocks.items.push_back(
            fmt::format("{} (task {}): {} cases, {}", block.name, block.task, block.cases.size(),
                        !analysis.data.conditions.isPair()
                            ? (block.views == ViewsOfCases::kAll ? "each in all conditions" : "each in one condition")
                        : block.views == ViewsOfCases::kAll ? "each in both views"
                                                            : "each in one view"));
      }
      work.document.add(blocks);
      break;
    }
  }
  const auto described = [&](TrialView view) {
    const ViewCondition& condition = analysis.data.conditions.of(view);
    return condition.description.empty() ? condition.label : condition.description;
  };
  if (!analysis.data.conditions.isPair()) {
    addConditionsOfDesign(work);
  } else {
    work.document.add(ReportParagraph{fmt::format(
        "Two views are compared: {}, and {}. Intervals are of 95 % where nothing else is said, and SE is the standard "
        "error, of ratios by the delta method; tests and intervals of "
        "ratios are of their logarithm. Outside of the tables of hypotheses p values are not corrected for their "
        "number. "
        "Tables that are marked as exploratory are not of a registered plan. The supplement has checks of the models, "
        "results without one case after the other, what was left out, and where each number comes from.",
        described(TrialView::kReference), described(TrialView::kOther))});
  }
  for (const std::string& note : analysis.data.notes) {
    work.document.add(ReportNote{NoteKind::kNote, note});
  }
  if (!analysis.data.tableFacts.empty()) {
    addHeading(work.document, 2, "What the tables tell, and what not", "tables");
    work.document.add(ReportList{analysis.data.tableFacts});
  }
}

/// What the plan foresaw is what its models and families give; tables that tell what was done are no results.
void markExploratory(ReportDocument& document, const AnalysisPlan& plan) {
  const auto isPlanned = [&](const std::string& id) {
    return plan.isRegistered() &&
           (plan.findModel(id) != nullptr ||
            std::any_of(plan.contrasts.begin(), plan.contrasts.end(),
                        [&](const PlannedContrast& contrast) {
                          return id == contrastTableOf(contrast.model) ||
                                 id == fmt::format("family-{}", contrast.family);
                        }) ||
            std::any_of(plan.families.begin(), plan.families.end(),
                        [&](const HypothesisFamily& family) { return id == fmt::format("family-{}", family.name); }));
  };
  for (std::vector<ReportElement>* part : {&document.elements, &document.supplement}) {
    for (ReportElement& element : *part) {
      if (auto* table = std::get_if<ReportTable>(&element)) {
        table->exploratory = !table->isRecord && !isPlanned(table->id);
      }
    }
  }
}

/// Answers first: what was added last stands before all else but a notice on who the subjects are.
void moveToFront(std::vector<ReportElement>& elements, size_t first, size_t front) {
  const auto at = [&](size_t index) { return elements.begin() + static_cast<std::ptrdiff_t>(index); };
  std::rotate(at(front), at(first), elements.end());
}

template <class Value>
std::string optionalText(const std::optional<Value>& value) {
  return value ? fmt::format("{}", static_cast<double>(*value)) : "";
}

std::string trialsCsv(const Dataset& data) {
  std::string text =
      "source,trial_id,subject_id,session_number,plan_index,block,task,case_index,item,view,moving,exposure_s,objects,"
      "duplicate_colors,answer,expected,correct,censored,response_s,dropped_frames,simulated";
  const bool isKnown = data.subjectsAreKnown();
  const CaseFactors cases(data);
  const std::vector<StudyFactor>& factors = data.conditions.factors;
  for (const StudyFactor& factor : factors) {
    text += "," + factor.name;
  }
  // Only studies with estimates, or with levels of staircases, have their columns.
  const bool hasEstimates = std::any_of(data.trials.begin(), data.trials.end(),
                                        [](const Trial& trial) { return estimatedValue(trial.measures).has_value(); });
  std::set<std::string> levels;
  for (const Trial& trial : data.trials) {
    for (const char* measure : {kLevelMeasure, kGuessRateMeasure}) {
      if (trial.measures.contains(measure)) {
        levels.insert(measure);
      }
    }
  }
  text += hasEstimates ? ",unit,estimate,truth,signed_error" : "";
  for (const std::string& measure : levels) {
    text += "," + measure;
  }
  text += "\r\n";
  for (const Trial& trial : data.trials) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", trial.source, trial.trialId,
                        csvText(trial.subject), trial.session, trial.planIndex, csvText(trial.block),
                        csvText(trial.task), trial.caseIndex, csvText(trial.item()), data.conditions.nameOf(trial.view),
                        optionalText(trial.moving), optionalText(trial.exposureSeconds), optionalText(trial.objects),
                        optionalText(trial.duplicateColors), csvText(trial.answer), csvText(trial.expected),
                        optionalText(trial.correct), optionalText(trial.censored), optionalText(trial.responseSeconds),
                        trial.droppedFrames, isKnown ? (trial.simulated ? "1" : "0") : "");
    for (const StudyFactor& factor : factors) {
      const FactorLevels& ofFactors = factor.ofCases ? cases.of(trial) : data.conditions.of(trial.view).levels;
      const auto level = ofFactors.find(factor.name);
      text += "," + (level == ofFactors.end() ? std::string() : csvText(level->second));
    }
    if (hasEstimates) {
      const std::optional<EstimatedValue> value = estimatedValue(trial.measures);
      text += value
                  ? fmt::format(",{},{},{},{}", value->unit->name, value->estimate, value->truth, value->signedError())
                  : std::string(",,,,");
    }
    for (const std::string& measure : levels) {
      const auto found = trial.measures.find(measure);
      text += "," + (found == trial.measures.end() ? std::string() : fmt::format("{}", found->second));
    }
    text += "\r\n";
  }
  return text;
}

/// With where each answer stands on its scale: the option from 1 to the number of options, and the view that the last
/// option speaks for.
std::string answersCsv(const Dataset& data) {
  const FormItems items(data);
  std::string text =
      "source,answer_id,subject_id,session_number,form,field,answer,question,option,options,last_favors\r\n";
  for (const FormAnswer& answer : data.answers) {
    const FormItem item = items.of(answer);
    const std::optional<int> place = item.placeOf(answer.answer);
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\r\n", answer.source, answer.answerId, csvText(answer.subject),
                        answer.session, csvText(answer.form), csvText(answer.field), csvText(answer.answer),
                        csvText(item.question), place ? std::to_string(*place) : "",
                        item.isScale() ? std::to_string(item.steps()) : "",
                        item.lastFavors ? data.conditions.nameOf(*item.lastFavors) : "");
  }
  return text;
}

}  // namespace

ReportDocument studyReport(const AnalysisData& analysis, const std::vector<Table>& tables,
                           const StudyReportOptions& options) {
  ReportDocument document;
  const bool simulated = analysis.data.isSimulated();
  document.title = "Analysis of a perception study";
  document.subtitle = analysis.data.sources.empty() ? "" : analysis.data.sources.front().protocolName;
  const bool isMarked = simulated || !analysis.data.subjectsAreKnown();
  document.marking = simulated ? "Simulated subjects" : isMarked ? "Not known: people or simulated" : "";
  document.version = options.version;
  document.created = options.created;
  for (const DataSource& source : analysis.data.sources) {
    document.origins.sources.push_back(source.path);
  }
  document.origins.conditions = analysis.data.conditions;
  ReportWork work{analysis, document, options.only};
  if (simulated) {
    document.add(
        ReportNote{NoteKind::kSimulated, "These results are of simulated subjects: they say nothing about people."});
  } else if (isMarked) {
    document.add(ReportNote{NoteKind::kWarning,
                            "Nothing says whether these subjects are people or simulated. \"subjects\" in the map of "
                            "columns says it."});
  }
  addPart(work, "Design and data", [&] { addDesign(work); });
  addPart(work, "Apparatus", [&] { addApparatus(work); });
  addPart(work, "Flow of subjects", [&] { addFlowSection(work); });
  const bool isPair = analysis.data.conditions.isPair();
  if (isPair) {
    addPart(work, "Tables of the study", [&] { addPaperSection(work, tables); });
  }
  const auto tell = [&](const std::string& stage, double done) {
    if (options.progress && !stage.empty()) {
      options.progress(stage, done);
    }
  };
  std::vector<ReportTask> wanted = reportTasksOf(analysis.data, analysis.plan);
  std::erase_if(wanted, [&](const ReportTask& task) { return !work.isWanted(task.name); });
  ContrastFamilies families;
  const auto addConditions = [&](const ReportTask& task) {
    tell(task.parts.front().stage, task.parts.front().done);
    addHeading(work.document, 1, task.title, fmt::format("conditions-of-{}", namePart(task.name)));
    addPart(work, fmt::format("Conditions of {}", task.name), [&] { addConditionTables(work, task); });
    addConditionModels(work, task, true, families);
  };
  const auto addTasks = [&](bool withTrials) {
    for (const ReportTask& task : wanted) {
      if (!isPair && task.hasTrials) {
        if (withTrials) {
          addConditions(task);
        }
        continue;
      }
      for (const TaskPart& part : task.parts) {
        if (task.hasTrials == withTrials) {
          tell(part.stage, part.done);
          addPart(work, part.title, [&] { part.add(work, task); });
        }
      }
      if (withTrials && task.hasTrials) {
        addConditionModels(work, task, false, families);
      }
    }
  };
  addTasks(true);
  std::vector<ReportTask> practised = wanted;
  std::erase_if(practised, [](const ReportTask& task) { return !task.hasTrials; });
  if (!practised.empty() && isPair) {
    tell("learning", 0.95);
    addPart(work, "Learning", [&] { addLearningSection(work, practised); });
    addPart(work, "Comparison of completers and drop-outs", [&] { addCompletersSection(work, practised); });
  }
  if (!practised.empty()) {
    addPart(work, "Speed against accuracy", [&] { addSpeedAccuracySection(work, practised); });
  }
  addTasks(false);
  if (hasOtherForms(analysis.data)) {
    addPart(work, "Questionnaires", [&] { addQuestionnaires(work); });
  }
  addPart(work, "Methods", [&] { addMethods(work, options.version); });
  addPart(work, "Provenance", [&] { addProvenance(work, options.version); });
  const size_t answers = document.elements.size();
  addPart(work, "Hypotheses", [&] { addHypotheses(work); });
  addPart(work, "Families of contrasts", [&] { families.write(work); });
  moveToFront(document.elements, answers, isMarked ? 1 : 0);
  markExploratory(document, analysis.plan);
  spellOutViews(document);
  return document;
}

std::vector<ReportFile> tableFiles(const AnalysisData& analysis, const ReportDocument& report,
                                   const StudyReportOptions& options, bool trials) {
  std::vector<ReportFile> files{{"tables/cells.csv", cellsCsv(report.origins.tables)},
                                {"tables/exclusions.csv", exclusionLogCsv(analysis.data)}};
  if (trials) {
    files.push_back({"tables/trials.csv", trialsCsv(analysis.data)});
    files.push_back({"tables/answers.csv", answersCsv(analysis.data)});
    if (hasOtherForms(analysis.data)) {
      files.push_back({"tables/scores.csv", scoresCsv(analysis.data)});
    }
    if (analysis.data.conditions.isPair()) {
      files.push_back({"analysis.R", rScript(analysis, options.only, options.version)});
    }
  }
  return files;
}

}  // namespace ocelli
