// Volumes of fields, on small displays, for the tests of this room.
#pragma once

#include <utility>

#include "display_sim/frames/display_profile.h"
#include "tests/volume/field_volume.h"

namespace ocelli::test {

/// A field over the cube of this half side around the origin of the display, by so many voxels a side.
template <class Field>
VolumeScene sceneOfField(int size, double halfSide, const Field& field, TransferFunction transfer) {
  const VolumeGrid grid = gridOfCube(size, halfSide);
  return sceneOfVoxels(grid, voxelsInWorld(grid, field), std::move(transfer));
}

inline DisplayProfile sweptProfile(int slices, int width, int height, int bits = 1,
                                   SecondHalfTurn secondHalfTurn = SecondHalfTurn::kMirrored) {
  DisplayProfile profile = loadProfile("test");
  profile.name = "swept";
  profile.slicesPerHalfTurn = slices;
  profile.width = width;
  profile.height = height;
  profile.colorBitsPerChannel = bits;
  profile.secondHalfTurn = secondHalfTurn;
  return profile;
}

}  // namespace ocelli::test
