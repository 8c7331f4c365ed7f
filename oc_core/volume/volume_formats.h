// The files of volumes that are read: a row a format. `ocelli-read-volume` (import/) has a reader for each.
//
// Recipe for a new format, three places:
//   1. oc_core/volume/volume_formats.cpp: a row with its name and the endings of its files.
//   2. oc_core/volume/import/NAME_file.cpp: a function that reads one, a VolumeFileReader. It throws InputError for all
//      that is no volume of scalars, with what to do next, and keeps the frame as the other formats do.
//   3. oc_core/volume/import/volume_reader_rows.h: the declaration of that function, and its row.
// The tests ask for a file that another program wrote, tests/volume_import/samples_test.cpp, and for the format's line
// in docs/volumes.md.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ocelli {

struct VolumeFormat {
  std::string_view name;                      ///< "NRRD"
  std::span<const std::string_view> endings;  ///< of file names, in lower case, with the point: ".nrrd"
  std::string_view headerEnding{};  ///< of those files whose voxels stand in others; empty where there are none
};

std::span<const VolumeFormat> volumeFormats();
inline constexpr std::string_view kDicomFormat = "DICOM";

/// The format of a file by the ending of its name, in any case; DICOM also by its first bytes, and for a folder that
/// has such a file. Null for any other file. That of a folder is the first of volumeFormatsIn().
const VolumeFormat* volumeFormatOf(const std::filesystem::path& path);
/// The same of a file's name alone.
const VolumeFormat* volumeFormatOfName(const std::filesystem::path& path);

/// Whether a file of this name is a header, whose voxels stand in other files.
bool hasDataElsewhere(const std::filesystem::path& path);

struct VolumeFormatFound {
  const VolumeFormat* format = nullptr;
  std::filesystem::path file;  ///< the first one of this format
  size_t files = 0;
};

/// The formats of the files of a folder, in the order of their names. Of those whose names do not say it, the first
/// 1024 are opened to see whether they are DICOM.
std::vector<VolumeFormatFound> volumeFormatsIn(const std::filesystem::path& folder);

/// Whether a file begins as DICOM files do: 128 bytes of anything, then "DICM".
bool isDicomFile(const std::filesystem::path& path);

/// The volume files of a folder, in the order of their names, where numbers count as numbers: "t2.nrrd" stands before
/// "t10.nrrd". Those of DICOM are none of them: a folder of these is one volume.
std::vector<std::filesystem::path> volumeFilesIn(const std::filesystem::path& folder);

/// What is read, for messages: "NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), ...".
std::string volumeFormatList();

}  // namespace ocelli
