// The ranks that run a command together: those of the MPI job that this process was started in, if it was.
#pragma once

#include <memory>
#include <string>

#include "oc_core/ranks/ranks.h"

namespace ocelli {

/// One rank where no launcher of MPI started this process, and nothing of MPI is touched then. Throws InputError where
/// a launcher started several of a command that does not divide its work, and WorkError where this program was built
/// without MPI: all of them would do the same work and write the same files.
std::unique_ptr<Ranks> startedRanks(bool divides, const std::string& command);

/// Before a rank prints why it failed: all but the first wait, since what one rank cannot do the others often cannot
/// either, and once the first has said so their launcher ends them. Returns what messages begin with: "rank 3: ".
std::string beforeFailureOfRank();

}  // namespace ocelli
