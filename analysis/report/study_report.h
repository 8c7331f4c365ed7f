// The whole report of a study: design, flow of subjects, tables, what is asked of each task, hypotheses, methods.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/exclusions.h"
#include "analysis/report/report_document.h"
#include "analysis/report/report_folder.h"
#include "analysis/tables/table.h"

namespace ocelli {

struct StudyReportOptions {
  std::set<std::string> only{};  ///< names of tasks (report_task.h); empty: all
  std::string version;           ///< of the program
  std::string created = "2000-01-01T00:00:00Z";
  /// Is told before each part of the work what it is, and how much is done, from 0 to 1. May be empty.
  std::function<void(std::string_view stage, double done)> progress{};
};

ReportDocument studyReport(const AnalysisData& analysis, const std::vector<Table>& tables,
                           const StudyReportOptions& options);

/// tables/cells.csv (all cells of the report) and tables/exclusions.csv, and with `trials` tables/trials.csv, each
/// analysed trial, tables/answers.csv, and analysis.R, which repeats the models from these.
std::vector<ReportFile> tableFiles(const AnalysisData& analysis, const ReportDocument& report,
                                   const StudyReportOptions& options, bool trials);

}  // namespace ocelli
