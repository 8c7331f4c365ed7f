// MetaImage (.mha, .mhd): lines "Name = value", then the voxels, or the names of the files that hold them. The format
// of MetaIO, as ITK reads and writes it: https://itk.org/Wiki/MetaIO/Documentation. A reader of our own, as MetaIO is
// packaged inside of ITK and VTK alone; it also says where uncompressed voxels lie, which those do not.
#pragma once

#include <string>
#include <vector>

#include "oc_core/volume/import/byte_source.h"
#include "oc_core/volume/import/voxel_output.h"

namespace ocelli {

struct MetaImageHeader {
  VolumeRecord
      record;  ///< grid, scale, offset, times, facts, warnings. Lengths in mm; frame LPS where the file has one
  uint64_t volumes = 1;
  StoredVoxels voxels;             ///< `offset` in the header's file where there are no others, else in each of them
  bool isOffsetFromEnd = false;    ///< `offset` counts for nothing: the voxels are the last bytes of the file
  std::vector<std::string> files;  ///< relative to the header's folder; empty: the voxels follow the header
};

/// Throws InputError for what is wrong, unknown or no volume of scalars.
MetaImageHeader parseMetaImage(const ByteSource& source);

}  // namespace ocelli
