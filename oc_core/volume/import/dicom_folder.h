// A folder of DICOM slices, or one DICOM file with several frames, through GDCM: http://gdcm.sourceforge.net
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {

/// For `ocelli-read-volume`; GDCM may crash. `path` is a folder, or a file, which stands for its folder unless it has
/// several frames itself; `series` as chooseSeries() says (dicom_slices.h). What is no DICOM file is passed over.
/// Throws InputError and WorkError.
VolumeRecord readDicom(const std::filesystem::path& path, const std::string& series, ScratchOutput& scratch,
                       ReadingBudget* budget);

}  // namespace ocelli
