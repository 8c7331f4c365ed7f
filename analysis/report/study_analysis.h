// An analysis from its sources to its report: what `ocelli analyse` does before it writes anything, and what Python
// gives as tables.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dataset/merge.h"
#include "analysis/report/study_report.h"

namespace ocelli {

/// As users write them.
inline constexpr std::array kSimulatedRowsNames{std::pair{"unless-people", SimulatedRows::kUnlessThereArePeople},
                                                std::pair{"only", SimulatedRows::kOnly},
                                                std::pair{"together", SimulatedRows::kTogetherWithPeople}};
/// Throws InputError, naming `where`, that lists the names.
SimulatedRows simulatedRowsFromName(const std::string& name, const std::string& where);

struct StudyAnalysisRequest {
  std::vector<std::string> sources;  ///< databases, folders of their export, or tables of another tool
  std::string plan{};                ///< a file; empty: defaultPlanOf()
  std::string protocol{};            ///< a file, of exports that do not hold it; or empty
  std::string columns{};             ///< a column map by name or file, of tables of other tools; or empty
  std::vector<std::string> only{};   ///< tasks; empty: all
  DatasetMergeOptions merge{};
  std::optional<uint64_t> seed{};  ///< in place of the plan's
};

struct StudyAnalysis {
  AnalysisData analysis;
  std::vector<Table> tables;  ///< paperTables()
};

/// Reads the sources, applies the plan and counts. Throws InputError for sources, files and tasks that are wrong.
StudyAnalysis analyseStudy(const StudyAnalysisRequest& request);

/// Nothing where no source says whether subjects are people or simulated.
std::optional<bool> isSimulated(const AnalysisData& analysis);

/// Now, as StudyReportOptions::created has it.
std::string reportTimeNow();

}  // namespace ocelli
