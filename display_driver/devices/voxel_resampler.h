// From the voxels of a rotating screen to the cells of a grid.
//
// Which voxels a cell has: those that fall in it both seen from above and in height. Seen from above, a voxel and a
// cell belong together where the centre of either lies in the other; the same in height. So each voxel is in some cell,
// and where voxels are larger than cells (few slices, near the rim) each cell has the voxel that holds its centre: a
// filled volume fills the grid, and a surface gets no holes that it did not have.
//
// What a cell shows: the light of its voxels, divided by the larger of two numbers: of its voxels that
// are lit, and of voxels in the thinnest cut through the cell. Volumes are surfaces in empty space, so a mean over all
// voxels would dim each surface by how finely its volume is sliced, most of all near the axis, where dozens of thin
// voxels fall in a cell of which a surface needs few. A mean over lit voxels alone would lose what dithers say with
// dark ones. The thinnest cut is the fewest voxels that a surface along the voxels' faces lights on its way through: N
// / max(a, b, c) of the N voxels of a cell, for N = a (angles) x b (radii) x c (heights). So full light stays full
// light in every direction, half of the voxels of a thinnest cut are half the light, and a surface that only touches a
// cell is dimmer there. What remains too bright: dithered surfaces along the other directions, as lit and dark voxels
// cannot be told from a surface that is thick and one that is thin. A cell of which any voxel is lit is lit (rgb332()).
//
// Where the second half turn has slices of its own, a voxel position is seen twice, and its light is the mean of both
// times, also where one of them is dark.
//
// A profile that is higher than the grid, in radii, is shown smaller, so that all of it is seen; nothing is ever
// stretched or enlarged.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "display_driver/devices/voxel_grid.h"
#include "display_sim/frames/volume.h"

namespace ocelli {

/// Keeps the sums of every cell and the volume that they came from: only slices that changed take time. For one thread
/// at a time.
class VoxelResampler {
 public:
  /// All cells are dark.
  VoxelResampler(const DisplayProfile& profile, const VoxelGrid& grid);

  /// Brings the cells to this volume of the profile, for a display that shows so many bits of each channel. nullopt:
  /// all slices may have changed since the last call; slices that are equal are found either way.
  void update(const Volume& volume, std::optional<std::span<const int>> changedSlices, int shownBits);

  /// RGB332 at VoxelGrid::index().
  std::span<const uint8_t> cells() const { return cells_; }
  const VoxelGrid& grid() const { return grid_; }
  /// How many times smaller than the model the grid shows it: 1 or less.
  double scale() const { return scale_; }

 private:
  /// Of a cell: levels summed over its lit voxel positions, and how many of those there are. A position is that of a
  /// voxel of the first half turn, and of the one that the second half turn has there.
  struct Sum {
    uint32_t red = 0;
    uint32_t green = 0;
    uint32_t blue = 0;
    uint32_t places = 0;
  };
  /// Lists of numbers, one after the other: list i is items[begins[i]] up to items[begins[i + 1]].
  struct Lists {
    std::vector<uint32_t> begins;
    std::vector<uint32_t> items;
    std::span<const uint32_t> of(size_t list) const {
      return std::span(items).subspan(begins[list], begins[list + 1] - begins[list]);
    }
  };

  /// Voxel positions of a cell seen from above: of all planes; and the larger of the number of planes and the number of
  /// positions of a plane.
  struct Extent {
    double places = 0;
    double longest = 0;
  };

  Lists columnsOfPlaces() const;
  Lists heightsOfRows() const;
  std::vector<Extent> extentsOfColumns() const;
  std::vector<double> rowsOfHeights() const;
  /// Takes the places of a plane, 0 to slices per half turn, into the sums (+1) or out of them (-1).
  void addPlane(int plane, int sign);
  void addPlace(int plane, int column, int row, const glm::uvec3& levels, int sign);
  void color(size_t column);

  VoxelGrid grid_;
  double scale_;
  Volume volume_;
  bool ownSecondHalf_;
  int shownBits_ = kMaxShownBits;
  Lists columns_;                ///< of a plane and a column of the screen: the columns of cells, as index / grid.z
  Lists heights_;                ///< of a row: the cells' z
  std::vector<Extent> extents_;  ///< of columns of cells
  std::vector<double> rows_;     ///< how many rows of the screen fall in a cell, by z
  std::vector<Sum> sums_;
  std::vector<uint8_t> changed_;  ///< 1 for columns of cells whose sums are newer than their colours
  std::vector<uint8_t> cells_;
};

}  // namespace ocelli
