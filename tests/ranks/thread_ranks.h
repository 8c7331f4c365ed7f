// Ranks that are threads of this process, for tests of what ranks do together: no MPI needed, any number of them.
#pragma once

#include <functional>

#include "oc_core/ranks/ranks.h"

namespace ocelli::test {

/// Calls `work` in each of so many ranks at once, and returns when all are done. What they throw is thrown here.
void runInRanks(int size, const std::function<void(Ranks& ranks)>& work);

}  // namespace ocelli::test
