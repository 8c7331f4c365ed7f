// Volumes of files: by `ocelli-read-volume` (import/), a process of its own (base/reader_process.h), where whatever a
// damaged file does to a library ends as an error message here.
//
// Voxels that a file holds as volumes have them (uncompressed, in the byte order of this machine, at a multiple of
// their size) are mapped from it. All others are written, as such, to a scratch file (base/scratch_file.h) in the
// folder for temporary files (TMPDIR), and mapped from there: memory is never asked for all of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/base/reader_process.h"
#include "oc_core/volume/scalar_volume.h"

namespace ocelli {

struct VolumeFileOptions {
  /// Of a folder of DICOM files with several: its UID or its number.
  std::string series{};
};

/// What a file, or a folder, holds: one volume, or the same grid at several times.
struct VolumeFile {
  std::vector<ScalarVolume> volumes;  ///< at least 1; all have one grid, and one type
  /// Of the volumes, in seconds, rising; empty where nothing says them.
  std::vector<double> times{};
  std::vector<std::string> warnings{};  ///< what the user should know of, a sentence each
};

/// Whether readVolumeFile() is for this file or folder: by the ending of its name, or as DICOM by its bytes. A folder,
/// by one of its files.
bool isVolumeFile(const std::filesystem::path& path);

/// A file; a folder of the slices of one volume in DICOM; or a folder of numbered volume files, which are volumes at
/// times 0, 1, 2, ... s. Frames: VolumeGrid.
///
/// Throws InputError for what is wrong with a file, WorkError where the reader is missing or there is no room for the
/// scratch file, and what `progress` throws.
VolumeFile readVolumeFile(const std::filesystem::path& path, const VolumeFileOptions& options = {},
                          const Progress& progress = {});

/// `ocelli-read-volume`. Its limits are set by OCELLI_VOLUME_MEMORY_GIB and OCELLI_VOLUME_SECONDS, its place by
/// OCELLI_VOLUME_READER.
const ReaderProgram& volumeReader();

}  // namespace ocelli
