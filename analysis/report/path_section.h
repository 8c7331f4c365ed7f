// Paths: whether they are recognised equally well in both views, and better than by guessing.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// The row with the p value of the test of equivalence, in the table of its model.
inline constexpr const char* kEquivalenceTestRow = "p of the two tests (the larger)";

void addPathSection(ReportWork& work);

/// How often a guess is right: by the maps of the protocol, or those of section 7.4.4 where none says.
double pathChance(const Dataset& data);

}  // namespace ocelli
