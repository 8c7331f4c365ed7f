// Two conditions side by side: what each gives, how they differ, and of how many subjects that is.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

struct ComparisonRow {
  std::string label;
  // Their own labels head the reasons where they cannot be estimated.
  EstimateRow first;
  EstimateRow second;
  EstimateRow difference;
  std::string subjects;  ///< how many, of each
};

struct ComparisonTable {
  std::string caption;
  std::string id;
  std::string first = "@reference@";
  std::string second = "@other@";
  std::string difference = "@other@ less @reference@";  ///< or a ratio
  bool tested = true;  ///< with standard error, statistic and p value of the difference
  std::vector<ComparisonRow> rows;
};

/// Each cell holds an estimate with its interval. What cannot be estimated is "-", and the notes below say why. Rows
/// without any estimate are left out, but for the notes. Cells are named as those of addEstimates(), by the labels of
/// their estimates.
void addComparison(ReportDocument& document, const ComparisonTable& table);

}  // namespace ocelli
