// Answers that are numbers: how far, which way. Which measures of a trial tell the estimate and the truth, in which
// unit, and what its error is. A task writes them (study/task/task.h, TrialOutcome::measures), an analysis reads them,
// whatever the task is called.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ocelli {

struct EstimateUnit {
  const char* name;   ///< ends the names of the measures: "estimate_m" and "truth_m"
  const char* words;  ///< "metres"
  /// Directions go around: 0 to below 360 degrees, clockwise. The others are lengths, above 0.
  bool isDirection;
};

/// A row each: "m" and "degrees".
std::span<const EstimateUnit> estimateUnits();
/// Throws InputError, saying `where`, for a unit that is not in the table.
const EstimateUnit& estimateUnit(std::string_view name, const std::string& where);

struct EstimatedValue {
  const EstimateUnit* unit = nullptr;  ///< of estimateUnits()
  double estimate = 0;
  double truth = 0;

  /// Of lengths log(estimate / truth): 0.1 is some 10 percent too far, -0.1 too near. Of directions the degrees by
  /// which the estimate lies clockwise of the truth, above -180 and to 180.
  double signedError() const;
};

/// The other way: what was answered where the signed error is `error`.
EstimatedValue estimateWithError(const EstimateUnit& unit, double truth, double error);

/// The measures of a trial: "estimate_m" and "truth_m" of metres.
std::map<std::string, double> measuresOf(const EstimatedValue& value);
/// Nothing where the measures hold no estimate, or numbers that the unit cannot have.
std::optional<EstimatedValue> estimatedValue(const std::map<std::string, double>& measures);

/// As answers and what was expected are stored: "3.25", "270"; at most four decimals.
std::string estimateText(double value);

/// Degrees, in the range of EstimatedValue::signedError().
double wrappedDegrees(double degrees);
/// Degrees, 0 to below 360: as directions are.
double withinTurn(double degrees);
inline constexpr double kDegreesOfTurn = 360;

}  // namespace ocelli
