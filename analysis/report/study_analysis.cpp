#include "analysis/report/study_analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "analysis/dataset/column_map.h"
#include "analysis/dataset/mapped_trials.h"
#include "analysis/report/default_plan.h"
#include "analysis/report/report_task.h"
#include "analysis/tables/paper_tables.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

void requireTasks(const std::vector<std::string>& wanted, const std::vector<std::string>& known) {
  for (const std::string& task : wanted) {
    if (std::find(known.begin(), known.end(), task) == known.end()) {
      throw InputError(fmt::format("this study has no task \"{}\"", task), "--only",
                       fmt::format("some of {}", fmt::join(known, ",")));
    }
  }
}

std::vector<Dataset> readSources(const StudyAnalysisRequest& request) {
  if (!request.columns.empty() && !request.protocol.empty()) {
    throw InputError("tables of other tools have no protocol of Ocelli", "--protocol", "--columns without it");
  }
  std::vector<Dataset> parts;
  if (!request.columns.empty()) {
    parts.push_back(readMappedTables(request.sources, readColumnMap(request.columns)));
    return parts;
  }
  for (const std::string& source : request.sources) {
    parts.push_back(readSource(source, request.protocol));
  }
  return parts;
}

}  // namespace

SimulatedRows simulatedRowsFromName(const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const auto& [known, rows] : kSimulatedRowsNames) {
    if (name == known) {
      return rows;
    }
    names.emplace_back(known);
  }
  throw InputError(fmt::format("\"{}\" does not say which rows to take", name), where,
                   fmt::format("one of {}", fmt::join(names, ", ")));
}

StudyAnalysis analyseStudy(const StudyAnalysisRequest& request) {
  Dataset data = merge(readSources(request), request.merge);
  const std::vector<std::string> tasks = plannableTasks(data);
  requireTasks(request.only, tasks);
  AnalysisPlan plan = request.plan.empty() ? defaultPlanOf(data) : readPlan(request.plan, tasks);
  plan.seed = request.seed.value_or(plan.seed);
  StudyAnalysis study{applyPlan(std::move(data), plan), {}};
  study.tables = paperTables(study.analysis);
  return study;
}

std::optional<bool> isSimulated(const AnalysisData& analysis) {
  return analysis.data.subjectsAreKnown() || analysis.data.isSimulated() ? std::optional(analysis.data.isSimulated())
                                                                         : std::nullopt;
}

std::string reportTimeNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace ocelli
