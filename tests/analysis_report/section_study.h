// Trials made by hand for the sections of a report, and what a section says of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/report_parts.h"
#include "analysis/report/report_task.h"

namespace ocelli::test {

class SectionStudy {
 public:
  /// Of a protocol text with so many sessions; 0: there is no protocol.
  explicit SectionStudy(int plannedSessions = 2);

  /// A completed search of the block "find stationary", or another task in a block of its own.
  Trial& add(const std::string& subject, int session, TrialView view, double seconds, bool correct = true,
             const std::string& task = "find");
  /// So many sessions, from the first.
  void complete(const std::string& subject, int sessions);

  AnalysisData analysis{};
};

/// The rows of these tasks.
std::vector<ReportTask> rowsOf(const std::vector<std::string>& tasks);

/// What the section writes.
ReportDocument documentOf(const AnalysisData& analysis, const std::function<void(ReportWork&)>& addSection);

/// "-" and the like too; "no such table" or "no such cell" where there is none. The row is the one whose head is `row`.
std::string cellText(const ReportDocument& document, const std::string& table, const std::string& row,
                     const std::string& column);
/// With all its digits.
std::optional<double> cellValue(const ReportDocument& document, const std::string& table, const std::string& row,
                                const std::string& column);
/// What cannot be estimated.
std::vector<std::string> reasonsOf(const ReportDocument& document);
bool hasFigure(const ReportDocument& document, const std::string& id);
/// Of the cell that has this name.
const Cell& originOf(const ReportDocument& document, const std::string& cell);

}  // namespace ocelli::test
