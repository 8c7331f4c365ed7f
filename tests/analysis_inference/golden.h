// What R gives for data that stand in the same file, golden.json, which golden.R made.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/survival_data.h"

namespace ocelli::test {

/// The numbers of that name; NaN where R has NA.
const std::vector<double>& golden(const std::string& name);
std::vector<int> goldenLabels(const std::string& name);

/// Times and events in seconds of a data set: "find", "lung", "veteran".
std::vector<SurvivalTime> goldenTimes(const std::string& set);
std::vector<int> goldenClusters(const std::string& set);
SurvivalData goldenData(const std::string& set, const std::vector<std::string>& covariates);

/// Each number agrees up to `tolerance` of its size, or of 1 where it is smaller; NaN with NaN.
void expectGolden(const std::vector<double>& actual, const std::string& name, double tolerance);

/// Of formulas that are evaluated in another order, and of fits that both sides carry to convergence.
inline constexpr double kClosedForm = 1e-10;
inline constexpr double kFitted = 1e-7;

}  // namespace ocelli::test
