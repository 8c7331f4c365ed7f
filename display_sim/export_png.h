// A volume as a stack of PNG files.
#pragma once

#include <filesystem>

#include "display_sim/volume.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// Writes slice_0000.png, slice_0001.png, ... into `folder`, which appears when all are there and replaces one that
/// holds nothing else: column x and row y of the slice at pixel (x, y), channels 0 or 255. Throws WorkError, and
/// InputError where the folder holds anything else.
void exportPngStack(const std::filesystem::path& folder, const Volume& volume, const Progress& progress = {});

}  // namespace ocelli
