// Frames that hold their number in every cell, so that parts of two frames show.
#pragma once

#include <cstdint>

#include "display_driver/devices/voxel_grid.h"
#include "display_sim/frames/volume.h"

namespace ocelli::test {

/// Few, large voxels, so that filled volumes are quickly resampled; three bits a channel hold 255 colours.
inline DisplayProfile numberedProfile() {
  DisplayProfile profile = loadProfile("vortex");
  profile.name = "numbered";
  profile.slicesPerHalfTurn = 8;
  profile.width = 16;
  profile.height = 8;
  profile.colorBitsPerChannel = 3;
  return profile;
}

/// A number from 1 to 255.
inline uint8_t frameNumberOf(uint32_t frame) {
  return static_cast<uint8_t>(1 + frame % 255);
}

/// The volume that gives every cell that the screen reaches this number, on a display that shows three bits.
inline Volume numberedVolume(const DisplayProfile& profile, uint8_t number) {
  Volume volume(profile);
  const ShownLevels shown = shownLevels(number, kMaxShownBits);
  // Blue has two bits there: thirds of the light, the nearest sevenths to which are 0, 2, 5 and 7.
  const Rgb8 levels(shown.level.r, shown.level.g, (7 * shown.level.b + 1) / 3);
  for (int slice = 0; slice < volume.slices(); ++slice) {
    for (int row = 0; row < volume.height(); ++row) {
      for (int column = 0; column < volume.width(); ++column) {
        volume.raise(slice, column, row, levels);
      }
    }
  }
  return volume;
}

}  // namespace ocelli::test
