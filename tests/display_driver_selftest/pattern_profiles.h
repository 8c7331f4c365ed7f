// Displays of all kinds for the tests of test patterns, small enough to look at every voxel.
#pragma once

#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"

namespace ocelli::test {

inline DisplayProfile patternProfile(int slices, int width, int height) {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = slices;
  profile.width = width;
  profile.height = height;
  profile.name = std::to_string(slices) + "x" + std::to_string(width) + "x" + std::to_string(height);
  return profile;
}

/// The smallest of them has hardly room for anything.
inline std::vector<DisplayProfile> patternProfiles() {
  std::vector<DisplayProfile> profiles{loadProfile("test"), patternProfile(36, 90, 70), patternProfile(23, 61, 45),
                                       patternProfile(2, 2, 1), patternProfile(5, 3, 2)};
  DisplayProfile low = patternProfile(30, 64, 32);
  low.halfHeightRadii = 0.5;
  low.colorBitsPerChannel = 3;
  low.channelTiming = ChannelTiming::kInTurn;
  profiles.push_back(low);
  DisplayProfile own = patternProfile(18, 40, 40);
  own.secondHalfTurn = SecondHalfTurn::kOwn;
  own.colorBitsPerChannel = 8;
  profiles.push_back(own);
  own.width = 41;
  own.slicesPerHalfTurn = 19;
  profiles.push_back(own);
  return profiles;
}

}  // namespace ocelli::test
