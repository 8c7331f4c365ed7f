// Ranks that slice together make the bytes of one.
#include "display_sim/slicing/shared_slicing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/ranks/thread_ranks.h"

namespace ocelli {
namespace {

DisplayProfile profileOf(int slices, int bits, SecondHalfTurn second) {
  DisplayProfile profile = test::smallProfile(slices, 32, 24);
  profile.colorBitsPerChannel = bits;
  profile.secondHalfTurn = second;
  return profile;
}

TEST(SlicesOfRank, areEachSliceOnce) {
  for (const SecondHalfTurn second : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const DisplayProfile profile = profileOf(10, 1, second);
    for (const int size : {1, 3, 10, 16}) {
      std::vector<int> all;
      for (int rank = 0; rank < size; ++rank) {
        const std::vector<int> slices = slicesOfRank(profile, rank, size);
        all.insert(all.end(), slices.begin(), slices.end());
      }
      std::sort(all.begin(), all.end());
      ASSERT_EQ(all.size(), static_cast<size_t>(profile.storedSlices()));
      for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i], static_cast<int>(i));
      }
    }
  }
}

void expectAlike(const DisplayProfile& profile, const SliceOptions& options, bool exact) {
  const Mesh mesh = test::torus(0.6, 0.3, 24, 16);
  const Volume alone =
      exact || needsExactSlicer(options) ? sliceExactly(mesh, profile, options) : slice(mesh, profile, options);
  ASSERT_GT(alone.litVoxels(), 0u);
  for (const int size : {1, 2, 3, 8, 16}) {
    test::runInRanks(size, [&](Ranks& ranks) {
      const Volume together = sliceTogether(mesh, profile, options, exact, ranks);
      if (ranks.isFirst()) {
        EXPECT_TRUE(together == alone) << size << " ranks";
      }
    });
  }
}

TEST(SliceTogether, isTheSameForAnyNumberOfRanks) {
  for (const SecondHalfTurn second : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    for (const int bits : {1, 8}) {
      const DisplayProfile profile = profileOf(10, bits, second);
      SliceOptions options;
      expectAlike(profile, options, false);
      expectAlike(profile, options, true);
      options.angularAntialiasing = true;
      expectAlike(profile, options, false);
      expectAlike(profile, options, true);
    }
  }
}

TEST(SliceTogether, isTheSameWithDiffusionAndEvenLight) {
  const DisplayProfile profile = profileOf(10, 1, SecondHalfTurn::kMirrored);
  SliceOptions options;
  options.colors = ColorReduction::kDiffusion;
  expectAlike(profile, options, false);
  options.evenLightRadius = 0.2;
  expectAlike(profile, options, false);
  options.colors = ColorReduction::kDither;
  expectAlike(profile, options, false);
}

}  // namespace
}  // namespace ocelli
