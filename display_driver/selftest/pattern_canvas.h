// Where test patterns are painted: every voxel by what it is to those who look at the display from outside. The voxel's
// convention is that of sweep_geometry.h.
#pragma once

#include <algorithm>
#include <cmath>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

struct PatternVoxel {
  int slice = 0;  ///< as stored, in [0, 2N)
  int column = 0;
  int row = 0;
  int sector = 0;  ///< in [0, 2N): where in space it lies, whichever half turn shows it
  int ring = 0;    ///< columns from the axis outwards, from 0
};

/// A profile with the counts that patterns are made of.
class PatternGrid {
 public:
  explicit PatternGrid(const DisplayProfile& profile) : profile_(profile), geometry_(profile) {}

  const DisplayProfile& profile() const { return profile_; }
  const SweepGeometry& geometry() const { return geometry_; }
  int sectors() const { return geometry_.sectors(); }
  int rows() const { return profile_.height; }
  int rings() const { return (profile_.width + 1) / 2; }

  PatternVoxel voxel(int slice, int column, int row) const {
    const bool right = 2 * column + 1 >= profile_.width;
    const int ring = right ? column - profile_.width / 2 : (profile_.width - 1) / 2 - column;
    const int half = geometry_.slicesPerHalfTurn();
    return {slice, column, row, right ? slice : (slice + half) % sectors(), ring};
  }

  /// Of the ring's middle.
  double radiusOf(int ring) const { return geometry_.columnRadius(profile_.width / 2 + ring); }
  double heightOf(int row) const { return geometry_.rowCenterY(row); }
  /// Of the sector's middle, from x towards z, in [0, 2 pi).
  double radiansOf(int sector) const { return sector * geometry_.stepRadians(); }

  /// The ring and row that hold a point; the nearest ones where none does. Rows count from the top.
  int ringAt(double radius) const {
    const double inner = profile_.width % 2 == 0 ? 0.0 : 0.5;
    return std::clamp(static_cast<int>(std::floor(radius * geometry_.columnsPerRadius() + inner)), 0, rings() - 1);
  }
  int rowAt(double y) const {
    return std::clamp(static_cast<int>(std::floor(geometry_.rowOfY(y))), 0, profile_.height - 1);
  }
  /// How many sectors a sector lies from another one, on the shorter way, with the sign of the rotation: in [-N, N).
  int sectorsFrom(int origin, int sector) const {
    const int half = geometry_.slicesPerHalfTurn();
    return (sector - origin + half + sectors()) % sectors() - half;
  }
  /// Whether an angle lies in a sector, its borders included.
  bool holds(int sector, double radians) const;

  uint8_t full() const { return static_cast<uint8_t>((1 << profile_.colorBitsPerChannel) - 1); }
  Rgb8 white() const { return Rgb8(full()); }

 private:
  DisplayProfile profile_;
  SweepGeometry geometry_;
};

/// Eight voxels of a row, from `column` on, as bits of all planes.
template <class Levels>
void paintByte(const PatternGrid& grid, int slice, int column, int row, uint8_t* byte, const VolumeLayout& layout,
               const Levels& levels) {
  const int bits = grid.profile().colorBitsPerChannel;
  for (int x = column; x < std::min(column + 8, grid.profile().width); ++x) {
    const Rgb8 light = levels(grid.voxel(slice, x, row));
    if (light == Rgb8(0)) {
      continue;
    }
    for (int plane = 0; plane < kColorChannels * bits; ++plane) {
      const unsigned bit = light[plane / bits] >> (plane % bits) & 1u;
      byte[static_cast<size_t>(plane) * layout.planeBytes] |= static_cast<uint8_t>(bit << (x - column));
    }
  }
}

/// The volume whose voxels have the levels (of red, green and blue) that `levels(PatternVoxel)` says.
template <class Levels>
Volume painted(const PatternGrid& grid, const Levels& levels) {
  Volume volume(grid.profile());
  const VolumeLayout& layout = volume.layout();
  parallelFor(layout.slices, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const int slice = static_cast<int>(i);
      uint8_t* bytes = volume.slice(slice).data();
      for (int row = 0; row < volume.height(); ++row) {
        for (int column = 0; column < volume.width(); column += 8) {
          const size_t at = static_cast<size_t>(row) * layout.rowBytes + static_cast<size_t>(column / 8);
          paintByte(grid, slice, column, row, bytes + at, layout, levels);
        }
      }
    }
  });
  return volume;
}

}  // namespace ocelli
