// Counts of one view beside those of the other: matched scenes, and mean errors of a subject.
#pragma once

#include <optional>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/inference/mcnemar.h"
#include "analysis/tables/table_cells.h"

namespace ocelli {

/// Scenes of a subject's session that are alike but for the view, in the order in which they came.
std::vector<PairedOutcome> matchedScenes(const TrialList& trials);

/// Of matched scenes: share right in other less that in reference, where subjects and scenes of a kind (block, session,
/// exposure, number, duplicates) are drawn from more of theirs.
Estimable<Estimate> matchedDifference(const TrialList& trials);

/// Answer less true number; nothing where either is no number.
std::optional<double> signedError(const Trial& trial);

/// Of each subject with answers in both views: mean error in other less that in reference.
std::vector<double> errorDifferences(const TrialList& trials);
/// The mean of these, where subjects and cases are drawn from more of theirs.
Estimable<Estimate> errorDifference(const TrialList& trials);

}  // namespace ocelli
