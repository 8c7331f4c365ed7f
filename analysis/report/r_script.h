// The models of a plan once more, as a script for R beside the tables that `--csv` writes: for those who go on there,
// and as a check of our numbers by other hands.
#pragma once

#include <set>
#include <string>

#include "analysis/dataset/exclusions.h"

namespace ocelli {

/// `Rscript analysis.R` in the folder of the report reads tables/trials.csv and tables/answers.csv, prints what it
/// finds and writes tables/r_results.csv: model, term, estimate, lower, upper, p. It needs lme4, lmerTest and survival.
/// `only`: tasks; empty: all.
std::string rScript(const AnalysisData& analysis, const std::set<std::string>& only, const std::string& version);

}  // namespace ocelli
