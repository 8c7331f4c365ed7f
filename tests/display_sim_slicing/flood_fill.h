// Flood fill of the dark voxels of a half turn from the border of the display, in the cylindrical topology of the
// sweep.
#pragma once

#include <vector>

#include "display_sim/frames/volume.h"

namespace ocelli::test {

struct Voxel {
  int slice;
  int column;
  int row;
};

class FloodFill {
 public:
  /// Fills at once. Neighbours share a face: the next column (across the axis too, where the sectors of a slice meet),
  /// the next row, the next slice; after the last slice comes the first, mirrored.
  explicit FloodFill(const Volume& volume)
      : volume_(volume),
        slices_(volume.profile().slicesPerHalfTurn),
        reached_(static_cast<size_t>(slices_) * static_cast<size_t>(volume.width() * volume.height())) {
    for (int slice = 0; slice < slices_; ++slice) {
      for (int row = 0; row < volume.height(); ++row) {
        for (int column = 0; column < volume.width(); ++column) {
          const bool border = row == 0 || row == volume.height() - 1 || column == 0 || column == volume.width() - 1;
          if (border) {
            reach({slice, column, row});
          }
        }
      }
    }
    while (!open_.empty()) {
      const Voxel v = open_.back();
      open_.pop_back();
      reach({v.slice, v.column - 1, v.row});
      reach({v.slice, v.column + 1, v.row});
      reach({v.slice, v.column, v.row - 1});
      reach({v.slice, v.column, v.row + 1});
      const int mirrored = volume.width() - 1 - v.column;
      reach(v.slice == 0 ? Voxel{slices_ - 1, mirrored, v.row} : Voxel{v.slice - 1, v.column, v.row});
      reach(v.slice == slices_ - 1 ? Voxel{0, mirrored, v.row} : Voxel{v.slice + 1, v.column, v.row});
    }
  }

  bool reached(const Voxel& v) const { return reached_[index(v)]; }

 private:
  size_t index(const Voxel& v) const {
    return (static_cast<size_t>(v.slice) * static_cast<size_t>(volume_.height()) + static_cast<size_t>(v.row)) *
               static_cast<size_t>(volume_.width()) +
           static_cast<size_t>(v.column);
  }

  void reach(const Voxel& v) {
    if (v.column < 0 || v.column >= volume_.width() || v.row < 0 || v.row >= volume_.height() || reached(v) ||
        volume_.colorBits(v.slice, v.column, v.row) != 0) {
      return;
    }
    reached_[index(v)] = true;
    open_.push_back(v);
  }

  const Volume& volume_;
  int slices_;
  std::vector<bool> reached_;
  std::vector<Voxel> open_;
};

}  // namespace ocelli::test
