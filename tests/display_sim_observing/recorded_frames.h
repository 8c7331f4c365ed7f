// Volumes that change from frame to frame in every way that a recording knows, made by code.
#pragma once

#include <cstdint>
#include <vector>

#include "display_sim/frames/volume.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli::test {

inline DisplayProfile recordedProfile(int slices, int width, int height, int bits) {
  DisplayProfile profile = smallProfile(slices, width, height);
  profile.colorBitsPerChannel = bits;
  return profile;
}

/// The volume of frame `number`. By the slice's number modulo 5: always dark; always the same; the same but for one
/// voxel; random anew in each frame; lit in even frames only.
inline Volume recordedVolume(const DisplayProfile& profile, uint32_t number) {
  Volume volume(profile);
  const auto full = static_cast<uint32_t>(volume.fullLevel());
  // A linear congruential step for every voxel: the same on every platform.
  const auto fill = [&](int slice, uint32_t seed) {
    uint32_t state = seed * 2654435761u + static_cast<uint32_t>(slice);
    for (int row = 0; row < volume.height(); ++row) {
      for (int column = 0; column < volume.width(); ++column) {
        state = state * 1664525u + 1013904223u;
        const uint32_t bits = state >> 8;
        volume.raise(slice, column, row, Rgb8(bits & full, bits >> 5 & full, bits >> 10 & full));
      }
    }
  };
  for (int slice = 0; slice < volume.slices(); ++slice) {
    switch (slice % 5) {
      case 1:
        fill(slice, 1);
        break;
      case 2: {
        fill(slice, 2);
        const auto place = static_cast<int>(number % static_cast<uint32_t>(volume.width()));
        volume.light(slice, place, volume.height() / 2, 7);
        break;
      }
      case 3:
        fill(slice, 100 + number);
        break;
      case 4:
        if (number % 2 == 0) {
          fill(slice, 4);
        }
        break;
      default:
        break;
    }
  }
  return volume;
}

/// When frame `number` is shown: 24 a second.
inline uint64_t recordedTime(uint32_t number) {
  return number * uint64_t{1000000} / 24;
}

/// What the recorder that is killed shows, over and over: made beforehand, so that it spends its time writing.
inline std::vector<Volume> killedVolumes() {
  std::vector<Volume> volumes;
  for (uint32_t k = 0; k < 8; ++k) {
    volumes.push_back(recordedVolume(recordedProfile(25, 64, 64, 3), k));
  }
  return volumes;
}

}  // namespace ocelli::test
