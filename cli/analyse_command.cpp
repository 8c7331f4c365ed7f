// `ocelli analyse`: from the trials of a study to a report.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/dataset/column_map.h"
#include "analysis/report/report_files.h"
#include "analysis/report/study_analysis.h"
#include "analysis/tables/explain.h"
#include "cli/command.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/unfinished_output.h"
#include "study/store/export_record.h"

namespace ocelli {
namespace {

struct AnalyseChoice {
  StudyAnalysisRequest request;
  std::string simulated = kSimulatedRowsNames.front().first;
  std::string folder;
  bool csv = false;
  std::string explain;
  bool asJson = false;
};

/// In the databases, so that a withdrawal finds the report: it names subjects, and holds rows of them with --csv.
void noteReport(const AnalysisData& analysis, const std::string& folder, const std::vector<ReportFile>& files,
                const CommandContext& context) {
  std::vector<std::string> names;
  for (const ReportFile& file : files) {
    names.push_back(file.name);
  }
  size_t tables = 0;
  for (const DataSource& source : analysis.data.sources) {
    if (source.form == DataSource::Form::kMappedTable) {
      ++tables;
    } else if (source.form != DataSource::Form::kDatabase) {
      context.note(
          fmt::format("{} are tables: a withdrawal from their database will not find this report", source.path));
    } else if (!recordReport(source.path, folder, names)) {
      context.note(fmt::format("{} could not note this report: a withdrawal will not find it", source.path));
    }
  }
  if (tables > 0) {
    context.note("these tables are of another tool: where a subject withdraws, delete this report by hand, too");
  }
}

void analyse(const AnalyseChoice& choice, const CommandContext& context) {
  if (!choice.folder.empty()) {
    checkReportFolder(choice.folder);
  }
  const StudyAnalysis study = analyseStudy(choice.request);
  const AnalysisData& analysis = study.analysis;
  const std::vector<Table>& tables = study.tables;
  if (choice.folder.empty() && findCell(tables, choice.explain) != nullptr) {
    context.print(explainCell(tables, analysis.data, choice.explain));
    return;
  }
  StudyReportOptions options;
  options.only = {choice.request.only.begin(), choice.request.only.end()};
  options.version = OCELLI_VERSION;
  options.created = reportTimeNow();
  options.progress = context.progress();
  const ReportDocument report = studyReport(analysis, tables, options);
  for (const std::string& warning : analysis.warnings) {
    context.note(fmt::format("caution: {}", warning));
  }
  for (const std::string& failure : report.failures) {
    context.note(fmt::format("a part of the report failed, and says so in its place: {}; please report this", failure));
  }
  if (!choice.explain.empty()) {
    context.print(explainCell(report.origins.tables, analysis.data, choice.explain));
  }
  if (choice.folder.empty()) {
    return;
  }
  std::vector<ReportFile> files = reportFiles(report);
  const std::vector<ReportFile> more = tableFiles(analysis, report, options, choice.csv);
  files.insert(files.end(), more.begin(), more.end());
  noteReport(analysis, choice.folder, files, context);
  // A signal waits until it is whole.
  UnfinishedOutput(unfinishedReportFolder(choice.folder), [] {}).finish([&] {
    writeReportFolder(choice.folder, files);
  });
  context.note(fmt::format("wrote {} files about {} trials of {} subjects to {}", files.size(),
                           analysis.flow.analysedTrials, analysis.flow.analysed, choice.folder));
  if (choice.asJson) {
    nlohmann::ordered_json json = {{"folder", choice.folder},
                                   {"data_sha256", analysis.dataSha256},
                                   {"plan_sha256", analysis.plan.sha256},
                                   {"subjects", analysis.flow.analysed},
                                   {"trials", analysis.flow.analysedTrials},
                                   {"simulated", nullptr}};
    if (const std::optional<bool> simulated = isSimulated(analysis)) {
      json["simulated"] = *simulated;
    }
    // The name of a folder may be any bytes.
    context.print(textOfJson(json, 2) + "\n");
  }
}

void runAnalyse(const AnalyseChoice& choice, const CommandContext& context) {
  if (choice.folder.empty() && choice.explain.empty()) {
    throw InputError("a report needs a folder", "-o", "-o FOLDER, or --explain CELL");
  }
  analyse(choice, context);
}

}  // namespace

void addAnalyseCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("analyse", "Analyse the trials of a study, as a report");
  const auto choice = std::make_shared<AnalyseChoice>();
  std::vector<std::string> simulatedNames;
  for (const auto& [name, rows] : kSimulatedRowsNames) {
    simulatedNames.emplace_back(name);
  }
  command
      .add_option("DB", choice->request.sources,
                  "Databases of a study, folders of its CSV export, or with --columns tables of other tools")
      ->required();
  command.add_option("--plan", choice->request.plan, "The registered plan of the analysis")->type_name("FILE");
  command.add_option("--protocol", choice->request.protocol, "The study's protocol, which CSV exports do not hold")
      ->type_name("FILE");
  command
      .add_option("--columns", choice->request.columns,
                  fmt::format("Read tables of another tool: which column is what, by {} or a map of your own",
                              fmt::join(builtInColumnMapNames(), ", ")))
      ->type_name("NAME|MAP.json");
  command.add_option("-o,--output", choice->folder, "Folder of the report: new, empty, or an earlier report")
      ->type_name("FOLDER");
  command.add_option("--only", choice->request.only, "Leave out the other tasks; survey is one")
      ->delimiter(',')
      ->type_name("TASK,TASK,...");
  command
      .add_option("--simulated", choice->simulated, "Which rows to take where there are people and simulated subjects")
      ->check(CLI::IsMember(simulatedNames))
      ->type_name(fmt::format("{}", fmt::join(simulatedNames, "|")))
      ->capture_default_str();
  command.add_flag("--other-protocols", choice->request.merge.allowOtherProtocols,
                   "Allow sources of different protocols");
  command.add_flag("--csv", choice->csv,
                   "Also the analysed trials and answers as CSV, and analysis.R, which repeats the models in R");
  command.add_option("--explain", choice->explain, "Print the rows behind a cell of the tables")->type_name("CELL");
  command.add_option("--seed", choice->request.seed, "Of what is random, in place of the plan's")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--json", choice->asJson, "Print hashes and counts as JSON");
  context.finish(command,
                 "  ocelli analyse study.db -o report\n"
                 "  ocelli analyse a.db b.db --plan plan.json --only find,count --csv -o report\n"
                 "  ocelli analyse data/*.csv --columns psychopy -o report\n"
                 "  ocelli analyse study.db --explain table-7.1/stationary/session-1/gc",
                 [choice, context] {
                   choice->request.merge.simulated = simulatedRowsFromName(choice->simulated, "--simulated");
                   runAnalyse(*choice, context);
                 });
}

}  // namespace ocelli
