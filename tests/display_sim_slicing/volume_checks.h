// What tests say of two volumes.
#pragma once

#include <gtest/gtest.h>

#include "display_sim/frames/volume.h"

namespace ocelli::test {

/// Each bit of `inner` is in `outer`.
inline ::testing::AssertionResult contains(const Volume& outer, const Volume& inner) {
  for (int i = 0; i < inner.slices(); ++i) {
    for (size_t at = 0; at < inner.layout().sliceBytes; ++at) {
      if ((inner.slice(i)[at] & ~outer.slice(i)[at]) != 0) {
        return ::testing::AssertionFailure()
               << "slice " << i << ", row " << at % inner.layout().planeBytes / inner.layout().rowBytes << ", byte "
               << at % inner.layout().rowBytes;
      }
    }
  }
  return ::testing::AssertionSuccess();
}

/// Voxels whose bits differ, of volumes of one profile.
inline size_t differingVoxels(const Volume& a, const Volume& b) {
  Volume difference(a.profile());
  for (int i = 0; i < a.slices(); ++i) {
    for (size_t at = 0; at < a.layout().sliceBytes; ++at) {
      difference.slice(i)[at] = a.slice(i)[at] ^ b.slice(i)[at];
    }
  }
  return difference.litVoxels();
}

}  // namespace ocelli::test
