// The readers of volume files: one for each row of volumeFormats() (oc_core/volume/volume_formats.h, which has the
// recipe for a new format). For `ocelli-read-volume`: libraries that read files may crash or run out of memory.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "oc_core/volume/import/voxel_output.h"
#include "oc_core/volume/volume_formats.h"

namespace ocelli {

struct VolumeReadingTask {
  std::filesystem::path path;  ///< a file or a folder
  std::string series{};        ///< of DICOM: VolumeFileOptions
};

/// Gives the record of a file, whose voxels stand in the file itself or in `scratch`. `budget` may be null. Throws
/// InputError for what is wrong with the file, and WorkError.
using VolumeFileReader = VolumeRecord(const VolumeReadingTask& task, ScratchOutput& scratch, ReadingBudget* budget);

/// A space of patients (RAS, LAS, LPS) becomes LPS, all others stay as they are.
VolumeFileReader readNrrd;
VolumeFileReader readMetaImage;
VolumeFileReader readVti;
/// The frame of the format, RAS, becomes LPS. Where a file has both the sform is taken, as nibabel does, else the
/// qform.
VolumeFileReader readNifti;
/// The path is that of a folder, or of a file with several frames; the series as chooseSeries() says (dicom_slices.h).
/// What is no DICOM file is passed over.
VolumeFileReader readDicom;

struct VolumeFileReaderRow {
  std::string_view format;  ///< the name of a row of volumeFormats()
  VolumeFileReader* read;
};

inline constexpr std::array kVolumeFileReaders{
    VolumeFileReaderRow{"NRRD", readNrrd}, VolumeFileReaderRow{"MetaImage", readMetaImage},
    VolumeFileReaderRow{"VTI", readVti}, VolumeFileReaderRow{"NIfTI", readNifti},
    VolumeFileReaderRow{kDicomFormat, readDicom}};

}  // namespace ocelli
