// Single volumes in `.svol` files. For recordings there are svol_writer.h, svol_reader.h and svol_player.h.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "display_sim/svol_reader.h"
#include "display_sim/volume.h"

namespace ocelli {

/// One frame at time 0. The file appears when it is complete. `metadata` is as in SvolOptions. Throws WorkError.
void writeSvol(const std::filesystem::path& path, const Volume& volume, const std::string& metadata = "{}");

/// The volume of one frame. Throws InputError where the file is damaged anywhere that opening it shows, or has no such
/// frame.
Volume readSvol(const std::filesystem::path& path, size_t frame = 0);
Volume readFrame(SvolReader& reader, size_t frame);
/// Throws the InputError that readFrame() would throw for a damaged file or a frame that is not there.
void requireFrame(const SvolReader& reader, size_t frame);

}  // namespace ocelli
