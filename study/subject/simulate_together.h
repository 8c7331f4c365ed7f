// Whole studies with simulated subjects (simulate_study.h), simulated by ranks together: each takes some of the
// subjects.
//
// SQLite is not made for files that several machines write to, so every rank but the first writes to a copy of the
// database beside it, FILE.rank1, FILE.rank2 and so on, which the first one merges into the database in the end and
// removes. Copies that a job left behind when it was ended are merged by the next one.
#pragma once

#include "oc_core/ranks/ranks.h"
#include "study/subject/simulate_study.h"

namespace ocelli {

/// As simulateStudy(), whose rows the database has in the end, those of other ranks' subjects behind those of the first
/// one's. The folder of the database is the same for all ranks. The result is that of all, in the first rank.
SimulationResult simulateTogether(const Protocol& protocol, const std::filesystem::path& database,
                                  const SimulationPlan& plan, Ranks& ranks, const Progress& progress = {});

}  // namespace ocelli
