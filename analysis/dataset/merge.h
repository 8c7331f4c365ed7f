// One data set from several: stations that ran the same study, or a database and an export of it.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"

namespace ocelli {

enum class SimulatedRows : uint8_t {
  kUnlessThereArePeople,  ///< people only, where there are any
  kOnly,
  kTogetherWithPeople,
};

struct DatasetMergeOptions {
  SimulatedRows simulated = SimulatedRows::kUnlessThereArePeople;
  bool allowOtherProtocols = false;
};

/// Rows that stand in several sources are taken once. What is left out is listed in `leftOut` and said in `notes`;
/// who withdrew from one of the sources is in none of the others (withdrawn_subjects.h).
/// Throws InputError, naming files and subjects, where protocols differ or are not known, and where a subject or a
/// planned trial has different contents in two sources. One part may hold people and simulated subjects too: merge it
/// alone.
Dataset merge(std::vector<Dataset> parts, const DatasetMergeOptions& options = {});

}  // namespace ocelli
