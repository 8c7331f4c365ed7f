// A volume as a KV6 voxel model (kv6_file.h): its lit voxels resampled to a grid of cubes, as for VTI (export_vti.h).
//
// Every lit cell is a voxel, also inside of solids, where no face is visible: a display that lets light through shows
// these too. Colours are levels scaled to 0 to 255, in equal steps of light. The pivot is the middle of the display. In
// model space x = (1, 0, 0), y = (0, 0, 1), z = (0, -1, 0): a turn and no mirror image. A voxel's height differs from
// its width by what makes a whole number of them fill the display, at most half a voxel over the whole height.
#pragma once

#include <filesystem>

#include "display_sim/exports/export_vti.h"
#include "display_sim/exports/kv6_file.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/progress.h"

namespace ocelli {

struct Kv6Options {
  /// Voxels across the display's diameter, in [2, 1024]. SLAB6 opens models of up to 256 x 256 x 255.
  int cellsAcross = 240;
};

/// Throws WorkError, and InputError for a size out of range.
void exportKv6(const std::filesystem::path& path, const Volume& volume, const Kv6Options& options = {},
               const Progress& progress = {});

/// A normal is the direction to the mean of the lit cells of the 5 x 5 x 5 around a voxel, as Voxlap estimates it.
/// Voxels without visible faces, and those in the middle of what surrounds them (sheets one cell thick), have none.
Kv6Model kv6Model(const CartesianVolume& grid);

}  // namespace ocelli
