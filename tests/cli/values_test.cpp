#include "cli/values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

TEST(ImageSizeFromText, ReadsWidthAndHeight) {
  const ImageSize size = imageSizeFromText("720x480", "--size");
  EXPECT_EQ(size.width, 720);
  EXPECT_EQ(size.height, 480);
  EXPECT_EQ(imageSizeFromText("1x32768", "--size").height, 32768);
}

TEST(ImageSizeFromText, RejectsEverythingElse) {
  for (const char* text : {"", "720", "720x", "x480", "720x480x3", "0x480", "720x-1", "32769x1", "1x99999999999",
                           "a x b", "720X480", " 720x480", "720x480 ", "7.5x4", "8193x8192", "32768x32768"}) {
    EXPECT_THROW(imageSizeFromText(text, "--size"), InputError) << text;
  }
}

TEST(PointFromText, ReadsThreeNumbers) {
  EXPECT_EQ(pointFromText("0,-0.5,1e1", "--eye"), glm::vec3(0, -0.5f, 10));
}

TEST(PointFromText, RejectsEverythingElse) {
  for (const char* text :
       {"", "1,2", "1,2,3,4", "1,2,", "1,,3", "nan,0,0", "inf,0,0", "1e99,0,0", "1, 2, 3", "a,b,c"}) {
    EXPECT_THROW(pointFromText(text, "--eye"), InputError) << text;
  }
}

TEST(RatioFromText, ReadsNumbersAndRatios) {
  EXPECT_EQ(ratioFromText("1/25", "--exposure"), 0.04);
  EXPECT_EQ(ratioFromText("0.04", "--exposure"), 0.04);
}

TEST(RatioFromText, RejectsEverythingElse) {
  for (const char* text : {"", "1/", "/25", "1/0", "1/2/3", "nan", "1:25"}) {
    EXPECT_THROW(ratioFromText(text, "--exposure"), InputError) << text;
  }
}

TEST(HalfSpaceFromText, ReadsAxesAndNormals) {
  EXPECT_EQ(halfSpaceFromText("x>0.25", "--clip"), glm::dvec4(1, 0, 0, 0.25));
  EXPECT_EQ(halfSpaceFromText("z<-2", "--clip"), glm::dvec4(0, 0, -1, 2));
  EXPECT_EQ(halfSpaceFromText("0,3,4,10", "--clip"), glm::dvec4(0, 0.6, 0.8, 2));
}

TEST(HalfSpaceFromText, RejectsEverythingElse) {
  for (const char* text : {"", "x", "x>", "x=1", "w>1", "x>1,2", "x>nan", "1,0,0", "0,0,0,1", "1,0,0,0,0", "nan,0,0,1",
                           "1e-300,0,0,1e300", "1.7e308,1.7e308,0,0"}) {
    EXPECT_THROW(halfSpaceFromText(text, "--clip"), InputError) << text;
  }
}

TEST(ColorFromText, ReadsSrgb) {
  EXPECT_EQ(colorFromText("#ffffff", "--background"), glm::vec3(1));
  // The sRGB curve: ((128 / 255 + 0.055) / 1.055)^2.4.
  EXPECT_NEAR(colorFromText("#008000", "--background").y, 0.2158605, 1e-6);
  EXPECT_EQ(colorFromText("#FF00fF", "--background"), glm::vec3(1, 0, 1));
}

TEST(ColorFromText, RejectsEverythingElse) {
  for (const char* text : {"", "red", "#fff", "#1234567", "123456#", "#12345g", "#-12345", "# 12345", "#+12345"}) {
    EXPECT_THROW(colorFromText(text, "--background"), InputError) << text;
  }
}

TEST(Values, TheErrorNamesTheOptionAndGivesAnExample) {
  try {
    imageSizeFromText("big", "--size");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("--size: \"big\""), testing::HasSubstr("--size 720x480")));
  }
}

}  // namespace
}  // namespace ocelli
