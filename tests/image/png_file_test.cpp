#include "oc_core/image/png_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/image/color.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

Image<Rgb8> gradient(int width, int height) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image(x, y) = {static_cast<uint8_t>(x * 7), static_cast<uint8_t>(y * 13), static_cast<uint8_t>(x ^ y)};
    }
  }
  return image;
}

// Made by hand: 2 x 1 pixels of 8-bit grey, 0 and 200.
constexpr unsigned char kGreyPng[] = {
    0x89, 0x50, 0x4e, 0x47, 0xd,  0xa,  0x1a, 0xa,  0x0,  0x0,  0x0,  0xd,  0x49, 0x48, 0x44, 0x52, 0x0,
    0x0,  0x0,  0x2,  0x0,  0x0,  0x0,  0x1,  0x8,  0x0,  0x0,  0x0,  0x0,  0xd1, 0x49, 0x20, 0x56, 0x0,
    0x0,  0x0,  0xb,  0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0x38, 0x1,  0x0,  0x0,  0xcb, 0x0,
    0xc9, 0x69, 0xc8, 0xc3, 0x6c, 0x0,  0x0,  0x0,  0x0,  0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

// 2 x 1 pixels of a 1-bit palette: (255, 128, 0) and (1, 2, 3).
constexpr unsigned char kPalettePng[] = {
    0x89, 0x50, 0x4e, 0x47, 0xd,  0xa,  0x1a, 0xa,  0x0,  0x0,  0x0,  0xd,  0x49, 0x48, 0x44, 0x52, 0x0,
    0x0,  0x0,  0x2,  0x0,  0x0,  0x0,  0x1,  0x1,  0x3,  0x0,  0x0,  0x0,  0xce, 0xec, 0xed, 0xc9, 0x0,
    0x0,  0x0,  0x6,  0x50, 0x4c, 0x54, 0x45, 0xff, 0x80, 0x0,  0x1,  0x2,  0x3,  0x5a, 0xb8, 0xfb, 0x9e,
    0x0,  0x0,  0x0,  0xa,  0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x70, 0x0,  0x0,  0x0,  0x42, 0x0,
    0x41, 0x29, 0x37, 0xf4, 0xef, 0x0,  0x0,  0x0,  0x0,  0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

// 1 x 1 pixel of 8-bit RGB with alpha: (10, 20, 30), opaque.
constexpr unsigned char kAlphaPng[] = {
    0x89, 0x50, 0x4e, 0x47, 0xd,  0xa,  0x1a, 0xa,  0x0,  0x0,  0x0,  0xd,  0x49, 0x48, 0x44, 0x52, 0x0, 0x0,
    0x0,  0x1,  0x0,  0x0,  0x0,  0x1,  0x8,  0x6,  0x0,  0x0,  0x0,  0x1f, 0x15, 0xc4, 0x89, 0x0,  0x0, 0x0,
    0xd,  0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xe0, 0x12, 0x91, 0xfb, 0xf,  0x0,  0x1,  0xa4, 0x1, 0x3c,
    0x93, 0x8b, 0xe,  0xb7, 0x0,  0x0,  0x0,  0x0,  0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

template <size_t kSize>
std::string_view bytesOf(const unsigned char (&bytes)[kSize]) {
  return {reinterpret_cast<const char*>(bytes), kSize};
}

TEST(PngFile, RoundTripIsExact) {
  const test::TemporaryFolder folder;
  // An odd width: rows are not padded.
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{37, 19}, std::pair{1, 300}}) {
    const Image<Rgb8> image = gradient(width, height);
    writePng(folder / "a.png", image);
    EXPECT_EQ(readPng(folder / "a.png"), image) << width << "x" << height;
  }
}

TEST(PngFile, ExpandsGreyAndPaletteAndDropsAlpha) {
  const test::TemporaryFolder folder;
  const Image<Rgb8> grey = readPng(folder.write("grey.png", bytesOf(kGreyPng)));
  EXPECT_EQ(grey(0, 0), Rgb8(0, 0, 0));
  EXPECT_EQ(grey(1, 0), Rgb8(200, 200, 200));
  const Image<Rgb8> palette = readPng(folder.write("palette.png", bytesOf(kPalettePng)));
  EXPECT_EQ(palette(0, 0), Rgb8(255, 128, 0));
  EXPECT_EQ(palette(1, 0), Rgb8(1, 2, 3));
  EXPECT_EQ(readPng(folder.write("alpha.png", bytesOf(kAlphaPng)))(0, 0), Rgb8(10, 20, 30));
}

TEST(PngFile, SameImageSameBytes) {
  const test::TemporaryFolder folder;
  writePng(folder / "a.png", gradient(64, 32));
  writePng(folder / "b.png", gradient(64, 32));
  EXPECT_EQ(test::fileBytes(folder / "a.png"), test::fileBytes(folder / "b.png"));
}

TEST(PngFile, RejectsMissingEmptyAndForeignFiles) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(readPng(folder / "missing.png"), InputError);
  EXPECT_THROW(readPng(folder.write("empty.png", "")), InputError);
  EXPECT_THROW(readPng(folder.write("text.png", "this is no image at all, only words")), InputError);
  EXPECT_THROW(readPng(folder.path()), InputError);
}

TEST(PngFile, RejectsEveryTruncation) {
  const test::TemporaryFolder folder;
  writePng(folder / "a.png", gradient(16, 16));
  const std::string whole = test::fileBytes(folder / "a.png");
  // The last chunk, IEND, holds no pixels: 12 bytes that a reader may do without.
  for (size_t length = 0; length + 12 < whole.size(); length += 5) {
    EXPECT_THROW(readPng(folder.write("cut.png", whole.substr(0, length))), InputError) << length << " bytes";
  }
}

TEST(PngFile, RejectsDamagedPixels) {
  const test::TemporaryFolder folder;
  writePng(folder / "a.png", gradient(16, 16));
  std::string bytes = test::fileBytes(folder / "a.png");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  EXPECT_THROW(readPng(folder.write("damaged.png", bytes)), InputError);
}

TEST(PngFile, RejectsAHugeClaimedSizeWithoutAllocatingIt) {
  const test::TemporaryFolder folder;
  writePng(folder / "a.png", gradient(4, 4));
  std::string bytes = test::fileBytes(folder / "a.png");
  // Width and height are the big-endian words at 16 and 20; the checksum no longer fits, either is reason to refuse.
  bytes.replace(16, 8, std::string("\x00\x0f\xff\xff\x00\x0f\xff\xff", 8));
  EXPECT_THROW(readPng(folder.write("huge.png", bytes)), InputError);
}

TEST(PngFile, WritingSaysWhereItFailed) {
  const test::TemporaryFolder folder;
  try {
    writePng(folder / "no" / "such" / "folder.png", gradient(4, 4));
    FAIL() << "nothing was thrown";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), HasSubstr("folder.png"));
    EXPECT_THAT(error.what(), HasSubstr("No such file or directory"));
  }
}

TEST(PngFile, WritingToAFolderOrAFullDiskFails) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(writePng(folder.path(), gradient(4, 4)), WorkError);
  // Larger than any buffer of stdio.
  EXPECT_THROW(writePng("/dev/full", gradient(512, 512)), WorkError);
  // Smaller than one: the failure shows only where the buffer is flushed.
  EXPECT_THROW(writePng("/dev/full", gradient(2, 2)), WorkError);
}

TEST(SrgbFromLinear, EncodesEachPixel) {
  Image<glm::vec3> linear(2, 1);
  linear(0, 0) = {0, 1, 0.21404114f};
  linear(1, 0) = {-1, 2, 0.5f};
  const Image<Rgb8> encoded = srgbFromLinear(linear);
  EXPECT_EQ(encoded(0, 0), Rgb8(0, 255, 128));  // 0.5 * 255 = 127.5 rounds up
  EXPECT_EQ(encoded(1, 0), Rgb8(0, 255, srgbByteFromLinear(0.5f)));
}

}  // namespace
}  // namespace ocelli
