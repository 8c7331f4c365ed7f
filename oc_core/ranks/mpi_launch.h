// Whether this process was started as a rank of an MPI job, from what the launcher left in its environment: known
// without MPI, and before MPI is initialised.
#pragma once

#include <optional>

namespace ocelli {

struct MpiLaunch {
  int rank = 0;
  int size = 1;
};

/// Nothing where no launcher started this process. Knows mpirun of Open MPI (OMPI_COMM_WORLD_RANK and _SIZE), launchers
/// that speak PMI (PMI_RANK and PMI_SIZE), and Slurm's srun with PMIx (PMIX_RANK and SLURM_STEP_NUM_TASKS).
std::optional<MpiLaunch> mpiLaunch();

}  // namespace ocelli
