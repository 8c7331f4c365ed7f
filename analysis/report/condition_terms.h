// The columns of a model of a study with several conditions, of its trials and of a grid.
//
// The grid has a row for each combination of a condition with levels of what else the model's terms part trials by
// (the levels that trials have of factors of cases, moving, duplicates); numbers are at their means. What a model says
// of a condition is the mean over its rows of the grid, and a contrast is a sum of rows with weights: estimated
// marginal means (Searle, Speed, Milliken 1980, Population marginal means in the linear model, Am. Stat. 34(4)). Each
// row of the grid counts alike, however many trials it has.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

class FixedEffects;

/// The levels of factors of cases, as the protocols of the sources have them.
class CaseFactors {
 public:
  explicit CaseFactors(const Dataset& data);
  /// Empty where the case has none.
  const FactorLevels& of(const Trial& trial) const;

 private:
  /// By source, block and place of the case.
  std::map<std::tuple<int, std::string, int>, FactorLevels> levels_{};
  FactorLevels none_{};
};

struct GridCell {
  size_t condition = 0;
  FactorLevels levels{};  ///< of factors other than those of conditions
};

class ConditionTerms {
 public:
  /// Takes the trials that have a value of each term and slope, and leaves out terms that do not vary over them.
  ConditionTerms(const Dataset& data, const PlannedModel& model, const TrialList& trials);

  const ViewConditions& conditions() const { return data_.conditions; }
  const TrialList& trials() const { return trials_; }
  /// Those of the model that vary, in its order.
  const std::vector<std::string>& terms() const { return terms_; }
  /// Which terms do not, and why: whole clauses.
  const std::vector<std::string>& leftOut() const { return leftOut_; }
  /// Why the terms cannot be made into columns; empty where they can.
  std::string problem() const;

  FixedEffects columns() const;
  const std::vector<GridCell>& grid() const { return grid_; }
  FixedEffects gridColumns() const;

  /// Whether a term or slope parts trials by levels, and is no number.
  bool isCategorical(const std::string& term) const;
  /// The level of each trial: of an interaction those of its parts, "graph/moving".
  std::vector<std::string> labelsOf(const std::string& term) const;
  /// The levels of a factor in their order, those of conditions included; empty for a number.
  std::vector<std::string> levelsOf(const std::string& factor) const;
  /// The factor of the protocol; nullptr where it has none of the name.
  const StudyFactor* findFactor(const std::string& name) const;

 private:
  std::string labelOf(const Trial& trial, const std::string& factor) const;
  std::string labelOf(const GridCell& cell, const std::string& factor) const;
  bool hasValue(const Trial& trial, const std::string& factor) const;
  bool varies(const std::string& factor) const;
  void leaveOutTerms();
  void makeGrid();

  const Dataset& data_;
  const PlannedModel& model_;
  CaseFactors cases_;
  TrialList trials_{};
  std::vector<std::string> terms_{};
  std::vector<std::string> leftOut_{};
  std::vector<GridCell> grid_{};
};

}  // namespace ocelli
