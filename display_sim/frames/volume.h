// A volume: how much red, green and blue every voxel shows, slice after slice, as the display takes it.
//
// With b bits a channel a voxel has a level from 0 (dark) to 2^b - 1 (full light) in each channel, in equal steps of
// light. A slice is 3 b bit planes: the b of red first, from the least significant, then those of green and of blue. A
// plane is its rows from the top, each padded to whole bytes with zero bits; column x is bit x % 8 (from the least
// significant) of byte x / 8 of its row.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "oc_core/base/check.h"
#include "oc_core/image/image.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

inline constexpr int kColorChannels = 3;

/// Sizes in bytes of the parts of a volume.
struct VolumeLayout {
  explicit VolumeLayout(const DisplayProfile& profile)
      : slices(static_cast<size_t>(profile.storedSlices())),
        rowBytes((static_cast<size_t>(profile.width) + 7) / 8),
        planeBytes(rowBytes * static_cast<size_t>(profile.height)),
        planes(static_cast<size_t>(kColorChannels * profile.colorBitsPerChannel)),
        sliceBytes(planeBytes * planes) {}

  size_t slices;
  size_t rowBytes;
  size_t planeBytes;
  size_t planes;  ///< of a slice
  size_t sliceBytes;
};

class Volume {
 public:
  /// All voxels dark.
  explicit Volume(DisplayProfile profile);

  const DisplayProfile& profile() const { return profile_; }
  const VolumeLayout& layout() const { return layout_; }
  int slices() const { return static_cast<int>(layout_.slices); }
  int width() const { return profile_.width; }
  int height() const { return profile_.height; }
  int bitsPerChannel() const { return profile_.colorBitsPerChannel; }
  /// The level of full light.
  int fullLevel() const { return (1 << bitsPerChannel()) - 1; }

  std::span<uint8_t> slice(int i) { return {bytes_.data() + offset(i), layout_.sliceBytes}; }
  std::span<const uint8_t> slice(int i) const { return {bytes_.data() + offset(i), layout_.sliceBytes}; }

  /// Of red, green and blue.
  Rgb8 levels(int slice, int column, int row) const;
  /// Where the given level is higher than the voxel's, it takes its place, in each channel.
  void raise(int slice, int column, int row, const Rgb8& levels);

  /// Which channels have any light: bit 0 red, bit 1 green, bit 2 blue; 0 is dark.
  unsigned colorBits(int slice, int column, int row) const;
  /// Gives these channels full light.
  void light(int slice, int column, int row, unsigned colorBits);

  /// All voxels dark again.
  void clear();

  size_t litVoxels() const;

  bool operator==(const Volume& other) const { return profile_ == other.profile_ && bytes_ == other.bytes_; }

 private:
  size_t offset(int i) const {
    OC_CHECK(i >= 0 && i < slices(), "slice out of range");
    return static_cast<size_t>(i) * layout_.sliceBytes;
  }

  DisplayProfile profile_;
  VolumeLayout layout_;
  std::vector<uint8_t> bytes_;
};

/// Levels of a voxel scaled to 0 to 255.
Rgb8 levelBytes(const Rgb8& levels, int fullLevel);

/// One slice as the screen shows it, in such bytes.
Image<Rgb8> sliceImage(const Volume& volume, int slice);

/// How many voxels of the bit planes of a slice have any light.
size_t countLit(std::span<const uint8_t> planes, const VolumeLayout& layout);

/// Eight bytes from `at` on of all planes, as one bit pattern: 0 where those 64 columns are dark.
inline uint64_t anyOfEightBytes(const uint8_t* planes, size_t at, const VolumeLayout& layout) {
  uint64_t any = 0;
  for (size_t plane = 0; plane < layout.planes; ++plane) {
    uint64_t bytes = 0;
    std::memcpy(&bytes, planes + plane * layout.planeBytes + at, sizeof bytes);
    any |= bytes;
  }
  return any;
}

/// Calls `visit(column, row)` for every lit voxel of a slice, row by row, left to right.
template <class Visit>
void forEachLitVoxel(const Volume& volume, int slice, Visit&& visit) {
  const VolumeLayout& layout = volume.layout();
  const uint8_t* planes = volume.slice(slice).data();
  for (int row = 0; row < volume.height(); ++row) {
    for (size_t i = 0; i < layout.rowBytes; ++i) {
      const size_t at = static_cast<size_t>(row) * layout.rowBytes + i;
      // Most voxels are dark.
      if (i % 8 == 0 && i + 8 <= layout.rowBytes && anyOfEightBytes(planes, at, layout) == 0) {
        i += 7;
        continue;
      }
      unsigned any = 0;
      for (size_t plane = 0; plane < layout.planes; ++plane) {
        any |= planes[plane * layout.planeBytes + at];
      }
      for (; any != 0; any &= any - 1) {
        visit(static_cast<int>(8 * i) + std::countr_zero(any), row);
      }
    }
  }
}

/// The same with its colour: `visit(column, row, colorBits)`.
template <class Visit>
void forEachLit(const Volume& volume, int slice, Visit&& visit) {
  forEachLitVoxel(volume, slice,
                  [&](int column, int row) { visit(column, row, volume.colorBits(slice, column, row)); });
}

/// The same with its levels: `visit(column, row, levels)`.
template <class Visit>
void forEachLevel(const Volume& volume, int slice, Visit&& visit) {
  forEachLitVoxel(volume, slice, [&](int column, int row) { visit(column, row, volume.levels(slice, column, row)); });
}

}  // namespace ocelli
