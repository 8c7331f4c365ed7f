#include "display_sim/frames/volume.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

struct Place {
  int column;
  int row;
  bool operator==(const Place&) const = default;
};

// Rows of less than eight bytes, of eight, and of more with and without a rest; planes of one and of several bits.
TEST(Volume, visitsLitVoxelsInOrder) {
  for (const int width : {7, 64, 100, 130, 768}) {
    for (const int bits : {1, 3}) {
      DisplayProfile profile = test::smallProfile(4, width, 5);
      profile.colorBitsPerChannel = bits;
      Volume volume(profile);
      std::vector<Place> expected;
      for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < width; ++column) {
          const int place = row * width + column;
          if (place % 41 == 0 || column == 0 || column == width - 1) {
            const auto level = static_cast<uint8_t>(1 + place % volume.fullLevel());
            volume.raise(2, column, row, place % 3 == 0 ? Rgb8(level, 0, 0) : Rgb8(0, 0, level));
            expected.push_back({column, row});
          }
        }
      }
      std::vector<Place> visited;
      forEachLitVoxel(volume, 2, [&](int column, int row) { visited.push_back({column, row}); });
      EXPECT_EQ(visited, expected) << width << " " << bits;
      EXPECT_EQ(volume.litVoxels(), expected.size());
    }
  }
}

}  // namespace
}  // namespace ocelli
