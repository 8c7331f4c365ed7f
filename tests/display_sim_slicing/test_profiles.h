// Small display profiles for the tests of this room.
#pragma once

#include "display_sim/frames/display_profile.h"

namespace ocelli::test {

inline DisplayProfile smallProfile(int slices, int width, int height,
                                   SecondHalfTurn secondHalfTurn = SecondHalfTurn::kMirrored) {
  DisplayProfile profile = loadProfile("test");
  profile.name = "small";
  profile.slicesPerHalfTurn = slices;
  profile.width = width;
  profile.height = height;
  profile.secondHalfTurn = secondHalfTurn;
  return profile;
}

}  // namespace ocelli::test
