// Ranks (oc_core/ranks/ranks.h) of an MPI job: MPI's own collectives and messages between two.
#pragma once

#include <memory>

#include "oc_core/ranks/ranks.h"

namespace ocelli {

/// Initialises MPI, which a process can do once; the last call on the result, its destructor, ends MPI again, and waits
/// for all ranks to do so. Calls come from the thread that made it. Throws WorkError where MPI cannot be initialised.
/// Messages may have up to 32 GiB.
std::unique_ptr<Ranks> mpiRanks();

}  // namespace ocelli
