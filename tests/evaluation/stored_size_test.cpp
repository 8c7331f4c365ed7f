#include "oc_core/evaluation/stored_size.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

TEST(StoredSize, countsColourAndDepthOfEveryPixel) {
  const ReferenceImage image = buildDepthImage(test::smallCamera(), test::boxBeforeWall());
  const StoredSize size = storedSize(image);
  EXPECT_EQ(size.raw, 90u * 60 * (3 + 1) * 4);
  EXPECT_LT(size.compressed, size.raw / 4) << "plain colours and flat depths";
  EXPECT_GT(size.compressed, 0u);
}

TEST(StoredSize, displacementsCountWhereThereAreAny) {
  ReferenceImage image = buildDepthImage(test::smallCamera(), test::wall(0));
  const StoredSize without = storedSize(image);
  image.displacement(3, 4) = {0.5f, 0};
  EXPECT_EQ(storedSize(image).raw, 90u * 60 * (3 + 1 + 2) * 4);
  EXPECT_GT(storedSize(image).compressed, without.compressed);
}

TEST(StoredSize, countsTheArraysOfAMesh) {
  Mesh mesh = test::wall(0);
  EXPECT_EQ(storedSize(mesh).raw, 4u * 12 + 4 * 12 + 2 * 12);
  mesh.colors.clear();
  EXPECT_EQ(storedSize(mesh).raw, 4u * 12 + 2 * 12);
  EXPECT_EQ(storedSize(Mesh{}).raw, 0u);
  EXPECT_EQ(storedSize(Mesh{}).compressed, 0u);
}

TEST(StoredSize, randomNumbersHardlyCompress) {
  const StoredSize size = storedSize(test::randomTriangles(1000, 1));
  EXPECT_GT(size.compressed, size.raw / 2);
}

TEST(StoredSize, addsUp) {
  StoredSize sum{3, 1};
  sum += {40, 20};
  EXPECT_EQ(sum.raw, 43u);
  EXPECT_EQ(sum.compressed, 21u);
}

}  // namespace
}  // namespace ocelli
