// Reference images as OpenEXR files: one image a file, or a union of several as a multi-part file.
//
// Channels, all 32-bit float: R G B (linear), Z (0 marks an empty sample) and offset.u, offset.v: the displacement, so
// that the pinhole of the stored view sees the sample of pixel centre (u, v) at (u - offset.u, v - offset.v). Placed
// samples (placed_image.h) have P.X P.Y P.Z instead, their world points, and D.X D.Y D.Z, the way of their rays there;
// Z is then the length of the ray. The string attribute `ocelli` of each part is a JSON object: "format" (1), "camera",
// "view" and, where they say something, "triangle_bound", "pinhole_size", "rows" ("shifted" or "shifted_ring"),
// "tile_side", "tile_spacing", "seen_from_aside", "placed", "wraps_around" and "layout" (docs/files.md).
#pragma once

#include <filesystem>
#include <string_view>

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// At least one image. Throws InputError for more than 64, WorkError where the file cannot be written in full.
void writeReferenceImages(const std::filesystem::path& path, const ReferenceImages& images);

/// Throws InputError for a file that is missing, broken, no EXR, or holds something else than reference images.
ReferenceImages readReferenceImages(const std::filesystem::path& path);
/// The same from the bytes of a file; `where` names them in messages.
ReferenceImages referenceImagesFromBytes(std::string_view bytes, const std::string& where);

}  // namespace ocelli
