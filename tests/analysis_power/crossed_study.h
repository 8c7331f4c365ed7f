// Studies of four conditions of two crossed factors, with known effects: for what an analysis makes of contrasts.
#pragma once

#include <map>
#include <string>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/dataset/dataset.h"
#include "study/protocol/protocol.h"

namespace ocelli::test {

/// 8 searches and 8 paths in each condition, in one session; searches of cases of two sizes. With the generator, so
/// fast.
Protocol crossedProtocol();

/// Of times: conditions in contrasts, a main effect of each factor, and their interaction; and the same of answers.
AnalysisPlan crossedPlan();

/// What the generator of crossedStudy() makes true of each contrast of crossedPlan(), by name: log ratios of times, log
/// odds ratios within a subject and a case.
const std::map<std::string, double>& crossedTruths();

/// So many subjects, who differ, and whose effects of conditions differ, as do those of cases.
Dataset crossedStudy(const Protocol& protocol, int subjects, uint64_t seed);

}  // namespace ocelli::test
