#include "oc_core/ranks/mpi_launch.h"

#include <cstdlib>
#include <string_view>

#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

std::optional<int> environmentNumber(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr) {
    return std::nullopt;
  }
  return numberFromText<int>(value);
}

}  // namespace

std::optional<MpiLaunch> mpiLaunch() {
  struct Launcher {
    const char* rank;
    const char* size;
  };
  for (const Launcher& launcher : {Launcher{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   Launcher{"PMI_RANK", "PMI_SIZE"}, Launcher{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}) {
    const std::optional<int> rank = environmentNumber(launcher.rank);
    const std::optional<int> size = environmentNumber(launcher.size);
    if (rank && size && *rank >= 0 && *rank < *size) {
      return MpiLaunch{*rank, *size};
    }
  }
  return std::nullopt;
}

}  // namespace ocelli
