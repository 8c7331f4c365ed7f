// Simulated studies straight into an analysis: what readDatabase() would read of the database that simulateStudy()
// would write, without the database.
#pragma once

#include "analysis/dataset/dataset.h"
#include "study/subject/simulate_study.h"

namespace ocelli {

/// Of generators: `plan.kind` is kGenerator. Trials stand in the order of subjects and sessions, numbered from 1; their
/// digests are zeros, so dataHash() tells nothing. On the calling thread alone.
Dataset simulatedDataset(const Protocol& protocol, const SimulationPlan& plan);
/// The same, but trials tell only whether they were right: "answer" and "expected" say nothing.
Dataset simulatedDatasetWithoutAnswers(const Protocol& protocol, const SimulationPlan& plan);

}  // namespace ocelli
