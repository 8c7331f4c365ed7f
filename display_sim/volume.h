// A volume: one bit for red, green and blue of every voxel, slice after slice, as the display takes it.
//
// A slice is three bit planes, red first; a plane is its rows from the top, each padded to whole bytes with zero bits;
// column x is bit x % 8 (from the least significant) of byte x / 8 of its row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display_sim/display_profile.h"
#include "oc_core/base/check.h"
#include "oc_core/base/image.h"
#include "oc_core/base/png_file.h"

namespace ocelli {

inline constexpr int kColorChannels = 3;

/// Sizes in bytes of the parts of a volume.
struct VolumeLayout {
  explicit VolumeLayout(const DisplayProfile& profile)
      : slices(static_cast<size_t>(profile.storedSlices())),
        rowBytes((static_cast<size_t>(profile.width) + 7) / 8),
        planeBytes(rowBytes * static_cast<size_t>(profile.height)),
        sliceBytes(planeBytes * kColorChannels) {}

  size_t slices;
  size_t rowBytes;
  size_t planeBytes;
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

  std::span<uint8_t> slice(int i) { return {bytes_.data() + offset(i), layout_.sliceBytes}; }
  std::span<const uint8_t> slice(int i) const { return {bytes_.data() + offset(i), layout_.sliceBytes}; }

  /// Bit 0 red, bit 1 green, bit 2 blue; 0 is dark.
  unsigned colorBits(int slice, int column, int row) const;
  void light(int slice, int column, int row, unsigned colorBits);

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

/// One slice as the screen shows it, channels 0 or 255.
Image<Rgb8> sliceImage(const Volume& volume, int slice);

/// Calls `visit(column, row, colorBits)` for every lit voxel of a slice, row by row, left to right.
template <class Visit>
void forEachLit(const Volume& volume, int slice, Visit&& visit) {
  const VolumeLayout& layout = volume.layout();
  const uint8_t* red = volume.slice(slice).data();
  const uint8_t* green = red + layout.planeBytes;
  const uint8_t* blue = green + layout.planeBytes;
  for (int row = 0; row < volume.height(); ++row) {
    for (size_t i = 0; i < layout.rowBytes; ++i) {
      const size_t at = static_cast<size_t>(row) * layout.rowBytes + i;
      const unsigned any = red[at] | green[at] | blue[at];
      if (any == 0) {
        continue;
      }
      for (unsigned bit = 0; bit < 8; ++bit) {
        if ((any >> bit & 1u) != 0) {
          visit(static_cast<int>(8 * i + bit), row,
                (red[at] >> bit & 1u) | (green[at] >> bit & 1u) << 1 | (blue[at] >> bit & 1u) << 2);
        }
      }
    }
  }
}

}  // namespace ocelli
