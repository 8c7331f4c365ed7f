#include "cli/started_ranks.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "oc_core/base/error.h"
#include "oc_core/ranks/mpi_launch.h"
#ifdef OCELLI_WITH_MPI
#include "oc_core/mpi/mpi_ranks.h"
#endif

namespace ocelli {

std::unique_ptr<Ranks> startedRanks(bool divides, const std::string& command) {
  const std::optional<MpiLaunch> launch = mpiLaunch();
  if (!launch || (launch->size == 1 && !divides)) {
    return serialRanks();
  }
  if (!divides) {
    throw InputError(fmt::format("\"{}\" does not divide its work among {} ranks", command, launch->size), "mpirun",
                     "run it by itself; docs/many_machines.md lists the commands that divide theirs");
  }
#ifdef OCELLI_WITH_MPI
  return mpiRanks();
#else
  if (launch->size == 1) {
    return serialRanks();
  }
  throw WorkError(fmt::format("this ocelli was built without MPI: {} of it would all do the same work", launch->size),
                  "mpirun", "run it without mpirun, or build it with -DOCELLI_WITH_MPI=ON (docs/install.md)");
#endif
}

std::string beforeFailureOfRank() {
  const std::optional<MpiLaunch> launch = mpiLaunch();
  if (!launch || launch->rank == 0) {
    return "";
  }
  std::this_thread::sleep_for(std::chrono::seconds(1));
  return fmt::format("rank {}: ", launch->rank);
}

}  // namespace ocelli
