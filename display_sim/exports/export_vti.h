// A volume as VTK image data (`.vti`), which ParaView opens: the lit voxels resampled to a grid of cubes.
//
// A cell of the grid has, in each channel, the highest level of the voxels that reach into it, found by points at most
// half a grid cell apart, so that surfaces stay whole at any resolution. Cell data `color`: three bytes, levels scaled
// to 0 to 255. Coordinates are display radii, y up.
#pragma once

#include <filesystem>

#include "display_sim/frames/volume.h"
#include "oc_core/base/progress.h"

namespace ocelli {

struct VtiOptions {
  /// Cells across the display's diameter, in [2, 1024]; as many of the same size as fit in its height.
  int cellsAcross = 256;
};

/// Throws WorkError, and InputError for a size out of range.
void exportVti(const std::filesystem::path& path, const Volume& volume, const VtiOptions& options = {},
               const Progress& progress = {});

/// Cells of the box [-1, 1] x [-h, h] x [-1, 1], the levels of each scaled to 0 to 255; x runs fastest, then y (up),
/// then z.
struct CartesianVolume {
  int sizeX = 0;
  int sizeY = 0;
  int sizeZ = 0;
  double spacing = 0;   ///< along x and z
  double spacingY = 0;  ///< about the same: a whole number of cells fills the height
  std::vector<Rgb8> cells;

  size_t index(int x, int y, int z) const {
    return (static_cast<size_t>(z) * static_cast<size_t>(sizeY) + static_cast<size_t>(y)) * static_cast<size_t>(sizeX) +
           static_cast<size_t>(x);
  }
};

/// Of a size that checkGridSize() lets pass.
CartesianVolume resample(const Volume& volume, int cellsAcross);
/// Throws InputError, naming `output`, where so many cells across are too few or too many.
void checkGridSize(int cellsAcross, const DisplayProfile& profile, const std::filesystem::path& output);

}  // namespace ocelli
