// A volume as a NRRD file (teem.sourceforge.net/nrrd/format.html), for scripts and viewers.
//
// A four-dimensional array of bytes, 0 or 255, gzip-compressed, fastest axis first: rgb, column, row, slice: the native
// voxels, not resampled. Key/value pairs hold what is needed to place them: `ocelli_profile` (the display profile as
// JSON) and `ocelli_geometry` (the formula of sweep_geometry.h, in words).
#pragma once

#include <filesystem>

#include "display_sim/frames/volume.h"
#include "oc_core/base/progress.h"

namespace ocelli {

/// Throws WorkError.
void exportNrrd(const std::filesystem::path& path, const Volume& volume, const Progress& progress = {});

}  // namespace ocelli
