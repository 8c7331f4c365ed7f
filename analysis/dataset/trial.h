// One trial that counts, as an analysis knows it: a row of `final_trial` (protocols/trials.schema.sql), and where it
// came from.
#pragma once

#include "oc_core/base/sha256.h"
#include "study/trial/trial_row.h"

namespace ocelli {

struct Trial : TrialRow {
  int source = 0;   ///< file of the dataset, from 0
  Digest digest{};  ///< of the row, with the columns that no analysis reads (row_digest.h)
};

}  // namespace ocelli
