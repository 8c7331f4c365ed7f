// How often counts are right by view, duration and duplicates, and whether the views differ more in some of these
// conditions than in others.
#pragma once

#include "analysis/report/report_parts.h"

namespace ocelli {

/// Figures and tables of shares and of differences of shares. Trials that do not know their condition are left out,
/// which a note says.
void addCountConditions(ReportWork& work, const TrialList& trials);

}  // namespace ocelli
