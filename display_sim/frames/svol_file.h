// Single volumes in `.svol` files. For recordings there are svol_writer.h, svol_reader.h and svol_player.h.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "display_sim/frames/svol_reader.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

/// One frame at time 0. The file appears when it is complete. `metadata` is as in SvolOptions. Throws WorkError.
void writeSvol(const std::filesystem::path& path, const Volume& volume, const std::string& metadata = "{}");

/// The volume of one frame. Throws InputError where that frame, or one that it needs, is damaged or not there; what
/// lies behind it may be damaged.
Volume readSvol(const std::filesystem::path& path, size_t frame = 0);
Volume readFrame(SvolReader& reader, size_t frame);
/// Throws the InputError that readFrame() would throw for a frame that is not there, or that lies at or beyond the
/// damage that opening the file has shown.
void requireFrame(const SvolReader& reader, size_t frame);

}  // namespace ocelli
