#include "analysis/report/study_report.h"

#include <fmt/format.h>

#include "analysis/dataset/csv_table.h"
#include "analysis/dataset/protocol_facts.h"
#include "analysis/report/completers_section.h"
#include "analysis/report/count_section.h"
#include "analysis/report/find_section.h"
#include "analysis/report/flow_section.h"
#include "analysis/report/learning_section.h"
#include "analysis/report/methods_section.h"
#include "analysis/report/navigation_section.h"
#include "analysis/report/paper_section.h"
#include "analysis/report/path_section.h"
#include "analysis/report/r_script.h"
#include "analysis/report/survey_section.h"

namespace ocelli {
namespace {

void addDesign(ReportWork& work, const StudyReportOptions& options) {
  const AnalysisData& analysis = work.analysis;
  addHeading(work.document, 1, "Design and data", "design");
  ReportFacts facts;
  facts.facts = {{"Program", fmt::format("Ocelli {}", options.version)},
                 {"Plan", describe(analysis.plan)},
                 {"Seed", std::to_string(analysis.plan.seed)},
                 {"SHA-256 of the data", analysis.dataSha256, true}};
  for (const DataSource& source : analysis.data.sources) {
    facts.facts.push_back({"Source", source.path});
    if (!source.protocolSha256.empty()) {
      facts.facts.push_back({fmt::format("Protocol {}", source.protocolName), source.protocolSha256, true});
    }
  }
  work.document.add(facts);
  if (!analysis.plan.isRegistered()) {
    work.document.add(
        ReportNote{NoteKind::kWarning,
                   "No plan was registered. Exclusions, models, hypotheses, families and bounds are the defaults of "
                   "Ocelli: nothing "
                   "here was decided for this study before its data were seen, and p values are exploratory."});
  }
  for (const DataSource& source : analysis.data.sources) {
    if (!source.protocolText.empty()) {
      const ProtocolFacts protocol = protocolFacts(source.protocolText, source.path);
      work.document.add(ReportParagraph{fmt::format("{}. {}", protocol.title, protocol.description)});
      ReportList blocks;
      for (const ProtocolBlockFacts& block : protocol.blocks) {
        blocks.items.push_back(fmt::format("{} (task {}): {} cases, {}", block.name, block.task, block.cases.size(),
                                           block.bothViews ? "each in both views" : "each in one view"));
      }
      work.document.add(blocks);
      break;
    }
  }
  work.document.add(ReportParagraph{
      "Views: ppc is the planar pinhole camera, gc the graph camera. Intervals are of 95 % where "
      "nothing else is said. Outside of the section on hypotheses p values are not corrected for their number."});
  for (const std::string& note : analysis.data.notes) {
    work.document.add(ReportNote{NoteKind::kNote, note});
  }
}

template <class Value>
std::string optionalText(const std::optional<Value>& value) {
  return value ? fmt::format("{}", static_cast<double>(*value)) : "";
}

std::string trialsCsv(const Dataset& data) {
  std::string text =
      "source,trial_id,subject_id,session_number,plan_index,block,task,case_index,item,view,moving,exposure_s,objects,"
      "duplicate_colors,answer,expected,correct,censored,response_s,dropped_frames,simulated\r\n";
  for (const Trial& trial : data.trials) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\r\n", trial.source,
                        trial.trialId, csvField(trial.subject), trial.session, trial.planIndex, csvField(trial.block),
                        csvField(trial.task), trial.caseIndex, csvField(trial.item()), nameOf(trial.view),
                        optionalText(trial.moving), optionalText(trial.exposureSeconds), optionalText(trial.objects),
                        optionalText(trial.duplicateColors), csvField(trial.answer), csvField(trial.expected),
                        optionalText(trial.correct), optionalText(trial.censored), optionalText(trial.responseSeconds),
                        trial.droppedFrames, trial.simulated ? 1 : 0);
  }
  return text;
}

std::string answersCsv(const Dataset& data) {
  std::string text = "source,answer_id,subject_id,session_number,form,field,answer\r\n";
  for (const FormAnswer& answer : data.answers) {
    text += fmt::format("{},{},{},{},{},{},{}\r\n", answer.source, answer.answerId, csvField(answer.subject),
                        answer.session, csvField(answer.form), csvField(answer.field), csvField(answer.answer));
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
  document.marking = simulated ? "Simulated subjects" : "";
  document.version = options.version;
  document.created = options.created;
  for (const DataSource& source : analysis.data.sources) {
    document.origins.sources.push_back(source.path);
  }
  ReportWork work{analysis, document, options.only};
  if (simulated) {
    document.add(
        ReportNote{NoteKind::kSimulated, "These results are of simulated subjects: they say nothing about people."});
  }
  addDesign(work, options);
  addFlowSection(work);
  addPaperSection(work, tables);
  std::vector<std::string> tasks;
  for (const char* task : {"find", "count", "path"}) {
    if (work.isWanted(task)) {
      tasks.emplace_back(task);
    }
  }
  const auto tell = [&](const char* stage, double done) {
    if (options.progress) {
      options.progress(stage, done);
    }
  };
  // How far it is with all tasks, by what parts of a study of 45 subjects take.
  if (work.isWanted("find")) {
    tell("searches", 0);
    addFindSection(work);
    tell("navigation", 0.4);
    addNavigationSection(work);
  }
  if (work.isWanted("count")) {
    tell("counts", 0.5);
    addCountSection(work);
  }
  if (work.isWanted("path")) {
    tell("paths", 0.9);
    addPathSection(work);
  }
  if (!tasks.empty()) {
    tell("learning", 0.95);
    addLearningSection(work, tasks);
    addCompletersSection(work, tasks);
  }
  if (work.isWanted("survey")) {
    addSurveySection(work);
  }
  addHypotheses(work);
  addMethods(work, options.version);
  return document;
}

std::vector<ReportFile> tableFiles(const AnalysisData& analysis, const ReportDocument& report,
                                   const StudyReportOptions& options, bool trials) {
  std::vector<ReportFile> files{{"tables/cells.csv", cellsCsv(report.origins.tables)},
                                {"tables/exclusions.csv", exclusionLogCsv(analysis.data)}};
  if (trials) {
    files.push_back({"tables/trials.csv", trialsCsv(analysis.data)});
    files.push_back({"tables/answers.csv", answersCsv(analysis.data)});
    files.push_back({"analysis.R", rScript(analysis, options.only, options.version)});
  }
  return files;
}

}  // namespace ocelli
