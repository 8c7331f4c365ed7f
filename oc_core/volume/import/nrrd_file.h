// NRRD (.nrrd, .nhdr) through Teem, whose format it is: http://teem.sourceforge.net/nrrd/format.html
#pragma once

#include <filesystem>

#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {

/// For `ocelli-read-volume`; Teem may crash or run out of memory. A space of patients (RAS, LAS, LPS) becomes LPS, all
/// others stay as they are. Throws InputError and WorkError.
VolumeRecord readNrrd(const std::filesystem::path& path, ScratchOutput& scratch, ReadingBudget* budget);

}  // namespace ocelli
