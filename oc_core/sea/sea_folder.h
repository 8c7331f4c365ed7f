// A sea as files that other programs read, and `ocelli sea build` too: its images as PNG, a table of where they were
// taken, and its proxy.
#pragma once

#include <filesystem>

#include "oc_core/base/progress.h"
#include "oc_core/sea/sea_file.h"

namespace ocelli {

/// Makes the folder. Of panoramas the table is positions.csv (file, x, y, z, qw, qx, qy, qz), of pinholes they are
/// COLMAP's cameras.txt and images.txt. Images have the names that they came with, or their numbers. The proxy, if there
/// is one, is proxy.ply. Throws WorkError where something cannot be written, InputError as SeaFile does.
void writeSeaFolder(const SeaFile& sea, const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace ocelli
