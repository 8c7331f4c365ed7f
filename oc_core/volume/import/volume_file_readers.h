// The readers of all formats: one for each row of volumeFormats() (volume_formats.h).
//
// How to add a format: a row in volume_formats.cpp, its reader in NAME_file.h and NAME_file.cpp here, and a row in
// volume_file_readers.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {

struct VolumeReadingTask {
  std::filesystem::path path;  ///< a file or a folder
  std::string series;          ///< of DICOM: VolumeFileOptions
};

/// Whether there is a reader of the format of this name.
bool hasVolumeFileReader(std::string_view format);

/// Reads what volumeFormatOf() knows. Throws InputError and WorkError.
VolumeRecord readVolumeRecord(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget);

}  // namespace ocelli
