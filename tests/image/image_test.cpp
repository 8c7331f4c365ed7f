#include "oc_core/image/image.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

TEST(Image, StartsFilled) {
  const Image<int> image(3, 2, 7);
  EXPECT_EQ(image.width(), 3);
  EXPECT_EQ(image.height(), 2);
  EXPECT_EQ(image.size(), 6u);
  for (const int pixel : image) {
    EXPECT_EQ(pixel, 7);
  }
}

TEST(Image, StoresRowsFromTheTop) {
  Image<int> image(3, 2);
  image(2, 0) = 1;
  image(0, 1) = 2;
  EXPECT_EQ(image[2], 1);
  EXPECT_EQ(image[3], 2);
  EXPECT_EQ(image.index(1, 1), 4u);
}

TEST(Image, ContainsItsPixelsOnly) {
  const Image<int> image(3, 2);
  EXPECT_TRUE(image.contains(0, 0));
  EXPECT_TRUE(image.contains(2, 1));
  EXPECT_FALSE(image.contains(3, 1));
  EXPECT_FALSE(image.contains(2, 2));
  EXPECT_FALSE(image.contains(-1, 0));
  EXPECT_FALSE(image.contains(0, -1));
}

TEST(Image, WithoutPixelsIsEmpty) {
  EXPECT_TRUE(Image<int>().empty());
  EXPECT_TRUE(Image<int>(0, 5).empty());
  EXPECT_FALSE(Image<int>(1, 1).empty());
}

TEST(Image, EqualityLooksAtShapeAndPixels) {
  EXPECT_EQ(Image<int>(3, 2), Image<int>(3, 2));
  EXPECT_FALSE(Image<int>(3, 2) == Image<int>(2, 3));
  EXPECT_FALSE(Image<int>(3, 2, 1) == Image<int>(3, 2, 2));
}

TEST(Image, SizesBeyondIntDoNotOverflow) {
  // 65536 x 65536 pixels do not fit an int; index() alone is asked, no pixel is stored.
  const Image<char> wide(65536, 1);
  EXPECT_EQ(wide.index(65535, 65535), 4294967295u);
}

TEST(ImageDeathTest, RejectsANegativeSize) {
  EXPECT_DEATH(Image<int>(-1, 2), "negative size");
}

}  // namespace
}  // namespace ocelli
