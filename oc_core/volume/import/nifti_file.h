// NIfTI-1 and NIfTI-2 (.nii, .nii.gz) through the reference library of the format: https://nifti.nimh.nih.gov
#pragma once

#include <filesystem>

#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {

/// For `ocelli-read-volume`; the library may crash. The frame of the format, RAS, becomes LPS. Where a file has both
/// the sform is taken, as nibabel does, else the qform. Throws InputError and WorkError.
VolumeRecord readNifti(const std::filesystem::path& path, ScratchOutput& scratch, ReadingBudget* budget);

}  // namespace ocelli
