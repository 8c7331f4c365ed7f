// Reference images as OpenEXR files.
//
// Channels, all 32-bit float: R G B (linear), Z (0 marks an empty sample) and offset.u, offset.v: the displacement, so
// that the pinhole of the stored view sees the sample of pixel centre (u, v) at (u - offset.u, v - offset.v). The
// string attribute `ocelli` is a JSON object: "format" (1), "camera", "view" and, where there is one, "triangle_bound".
#pragma once

#include <filesystem>
#include <string_view>

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// Throws WorkError where the file cannot be written in full.
void writeReferenceImage(const std::filesystem::path& path, const ReferenceImage& image);

/// Throws InputError for a file that is missing, broken, no EXR, or no reference image.
ReferenceImage readReferenceImage(const std::filesystem::path& path);
/// The same from the bytes of a file; `where` names them in messages.
ReferenceImage referenceImageFromBytes(std::string_view bytes, const std::string& where);

}  // namespace ocelli
