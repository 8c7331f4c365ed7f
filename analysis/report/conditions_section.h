// What the report of a study tells of its conditions where they are not a pair, or where the plan names contrasts: of
// each task tables of its conditions, mixed models with their contrasts, and forest plots of these; and the contrasts
// of all tasks by family, corrected by Holm's method.
//
// Sections that compare two views, among them the tables of chapter 7 and what replicates its figures, are no part of
// such a report: it says so.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/condition_model.h"
#include "analysis/report/report_task.h"

namespace ocelli {

/// A contrast that was asked for, and what became of it.
struct AskedContrast {
  PlannedContrast contrast;
  std::string measure;  ///< "ratio of times, graph-low / pinhole-low"
  Estimable<Estimate> effect = Estimable<Estimate>::impossible("its model was not fitted");
  std::string cell{};  ///< of its p value in the table of its model; empty where there is none
};

/// Of the plan, or of the default contrasts of its models: all that stand in the report.
class ContrastFamilies {
 public:
  void add(AskedContrast asked) { asked_.push_back(std::move(asked)); }
  bool isEmpty() const { return asked_.empty(); }
  /// "What was found": a table a family.
  void write(ReportWork& work) const;

 private:
  std::vector<AskedContrast> asked_{};
};

/// The table of a model's contrasts: "find-time-contrasts".
std::string contrastTableOf(const std::string& model);

/// Tables of the conditions of a task.
void addConditionTables(ReportWork& work, const ReportTask& task);
/// Its mixed models that have contrasts, or all of them where `all`.
void addConditionModels(ReportWork& work, const ReportTask& task, bool all, ContrastFamilies& families);

}  // namespace ocelli
