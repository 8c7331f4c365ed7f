#include "oc_core/volume/scalar_volume.h"

#include <gtest/gtest.h>

#include "oc_core/volume/volume_scene.h"
#include "tests/volume/field_volume.h"

namespace ocelli {
namespace {

/// 2 x 3 x 4 voxels whose value is 1 i + 10 j + 100 k.
ScalarVolume linearVolume() {
  const VolumeGrid grid{.size = {2, 3, 4}};
  return {grid, test::voxelsOf(grid.size, [](const glm::dvec3& p) { return p.x + 10 * p.y + 100 * p.z; })};
}

TEST(ScalarVolume, InterpolatesBetweenCentresAndHoldsTheLastHalfVoxel) {
  const ScalarVolume volume = linearVolume();
  EXPECT_EQ(volume.valueAt({1, 2, 3}), 321);
  EXPECT_DOUBLE_EQ(volume.fieldAt({0.25, 1.5, 2.75}), 0.25 + 15 + 275);
  EXPECT_DOUBLE_EQ(volume.fieldAt({-0.5, -0.5, -0.5}), 0);
  EXPECT_DOUBLE_EQ(volume.fieldAt({1.5, 2.5, 3.5}), 321);
  const ValueRange range = valueRange(volume);
  EXPECT_EQ(range.least, 0);
  EXPECT_EQ(range.greatest, 321);
}

TEST(ScalarVolume, StandsInItsScene) {
  const VolumeScene scene = loadVolumeScene("builtin:volume,name=marschner-lobb");
  const Box box = scene.bounds();
  EXPECT_NEAR(glm::length(box.size()), 2, 1e-5);
  EXPECT_NEAR(glm::length(box.center()), 0, 1e-5);
}

}  // namespace
}  // namespace ocelli
