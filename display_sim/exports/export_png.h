// A volume as a stack of PNG files.
#pragma once

#include <filesystem>

#include "display_sim/frames/volume.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// Writes slice_0000.png, slice_0001.png, ... into `folder`, where they appear when all are there, in place of those
/// of an earlier run: column x and row y of the slice at pixel (x, y), levels scaled to 0 to 255. Throws WorkError, and
/// InputError where the folder is a file.
void exportPngStack(const std::filesystem::path& folder, const Volume& volume, const Progress& progress = {});

}  // namespace ocelli
