// Volumes with something in them, for tests of what carries volumes.
#pragma once

#include <string>

#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/volume.h"
#include "oc_core/base/random.h"

namespace ocelli {

/// Of so many slices, with a width that is no multiple of eight.
inline DisplayProfile smallProfile(int slices = 11, int bits = 1) {
  DisplayProfile profile = loadProfile("test");
  profile.slicesPerHalfTurn = slices;
  profile.width = 37;
  profile.height = 19;
  profile.colorBitsPerChannel = bits;
  return profile;
}

/// Lights random voxels: about this share of them.
inline void lightSome(Volume& volume, Random& random, double share = 0.02) {
  const double voxels = static_cast<double>(volume.slices()) * volume.width() * volume.height();
  for (auto left = static_cast<int>(share * voxels) + 1; left > 0; --left) {
    const auto pick = [&](int count) { return static_cast<int>(random.below(static_cast<size_t>(count))); };
    volume.light(pick(volume.slices()), pick(volume.width()), pick(volume.height()), 1 + pick(7));
  }
}

inline Volume madeVolume(const DisplayProfile& profile, uint64_t seed, double share = 0.02) {
  Volume volume(profile);
  Random random(seed);
  lightSome(volume, random, share);
  return volume;
}

}  // namespace ocelli
