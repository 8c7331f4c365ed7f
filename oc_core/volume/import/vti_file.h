// VTI, image data of VTK in XML: ascii, base64 or appended arrays, deflated by zlib or not. A reader of our own: VTK's
// brings 150 packages. https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
//
// The values at points are voxels there; those of cells are voxels in their middles.
#pragma once

#include <string>

#include "oc_core/volume/import/byte_source.h"
#include "oc_core/volume/import/voxel_output.h"
#include "oc_core/volume/import/vti_encoding.h"

namespace ocelli {

struct VtiHeader {
  VolumeRecord record;  ///< grid, facts, warnings. The frame is that of the file; VTK knows no other, and no units
  StoredType type = StoredType::kUint8;
  VtiEncoding encoding;
  bool isText = false;    ///< numbers in `content`
  bool isInline = false;  ///< the array stands in `content`, else in the file at `offset`
  std::string content;
  uint64_t offset = 0;  ///< of the array's header
};

/// Throws InputError for what is wrong, unknown or no volume of scalars.
VtiHeader parseVti(const ByteSource& source);

/// Sets where the record's voxels lie, and writes them where they must be made. `path` is that of the source. Throws
/// InputError and WorkError.
void placeVtiVoxels(VtiHeader& header, const ByteSource& source, const std::string& path, ScratchOutput& scratch);

}  // namespace ocelli
