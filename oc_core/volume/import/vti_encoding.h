// The bytes of an array in a VTK XML file: raw or in base64, deflated by blocks or not, behind a header that says their
// size. As vtkXMLWriter writes them: https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
#pragma once

#include <cstdint>

#include "oc_core/base/byte_sink.h"
#include "oc_core/volume/import/byte_source.h"

namespace ocelli {

struct VtiEncoding {
  bool isBase64 = false;
  bool isDeflated = false;  ///< by zlib, each block for itself
  bool isSwapped = false;   ///< numbers of headers have the other byte order than this machine's
  size_t wordBytes = 4;     ///< of the numbers of headers: 4 or 8
};

/// A number of a header. Throws InputError where the source ends before.
uint64_t readVtiWord(const VtiEncoding& encoding, const ByteSource& source, uint64_t offset);

/// Hands on the bytes of an array, whose header stands at `offset` of the source. Throws InputError where they are
/// damaged or not `expected` many.
void decodeVtiArray(const VtiEncoding& encoding, const ByteSource& source, uint64_t offset, uint64_t expected,
                    const ByteSink& sink);

}  // namespace ocelli
