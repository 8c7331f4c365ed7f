#include "oc_core/image_codecs/image_codec.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/image/image_error.h"
#include "tests/image_codecs/coded_samples.h"

namespace ocelli {
namespace {

using namespace test;

constexpr glm::ivec2 kOddSizes[] = {{1, 1}, {1, 7}, {9, 1}, {37, 23}, {300, 180}};

double psnrAfter(const ColorCodec& codec, const Image<Rgb8>& image, double quality) {
  const std::vector<std::byte> bytes = codec.encode(image, quality);
  return psnrDecibels(meanSquaredError(codec.decode(bytes, {image.width(), image.height()}), image));
}

class EachColorCodec : public testing::TestWithParam<ColorCodec> {};
class EachDepthCodec : public testing::TestWithParam<DepthCodec> {};

const auto kRowName = [](const auto& row) { return std::string(row.param.name); };
INSTANTIATE_TEST_SUITE_P(All, EachColorCodec, testing::ValuesIn(colorCodecs().begin(), colorCodecs().end()), kRowName);
INSTANTIATE_TEST_SUITE_P(All, EachDepthCodec, testing::ValuesIn(depthCodecs().begin(), depthCodecs().end()), kRowName);

TEST_P(EachColorCodec, GivesImagesBack) {
  for (const glm::ivec2& size : kOddSizes) {
    for (const Image<Rgb8>& image : {coloredDisc(size.x, size.y), colorNoise(size.x, size.y)}) {
      const std::vector<std::byte> bytes = GetParam().encode(image, 90);
      const Image<Rgb8> decoded = GetParam().decode(bytes, size);
      ASSERT_EQ(glm::ivec2(decoded.width(), decoded.height()), size);
      if (GetParam().isLossless) {
        EXPECT_EQ(decoded, image);
      }
    }
  }
}

TEST_P(EachColorCodec, LossesFallWithQuality) {
  if (GetParam().isLossless) {
    EXPECT_EQ(psnrAfter(GetParam(), coloredDisc(300, 180), 0), psnrAfter(GetParam(), coloredDisc(300, 180), 100));
    return;
  }
  // Of an image with one hard, coloured edge. 30 dB are an error of 8 levels of 255, which all of them stay below
  // at 90.
  const Image<Rgb8> image = coloredDisc(300, 180);
  const double low = psnrAfter(GetParam(), image, 20);
  const double high = psnrAfter(GetParam(), image, 90);
  EXPECT_GT(high, 30);
  EXPECT_GT(high, low + 2);
  EXPECT_LT(GetParam().encode(image, 20).size(), GetParam().encode(image, 90).size());
}

TEST_P(EachColorCodec, CompressesWhatIsSmooth) {
  EXPECT_LT(GetParam().encode(coloredDisc(300, 180), 80).size(), size_t{300 * 180});  // a third of the pixels' bytes
}

TEST_P(EachDepthCodec, GivesImagesBack) {
  for (const glm::ivec2& size : kOddSizes) {
    for (const Image<uint16_t>& image : {depthOfDisc(size.x, size.y), depthNoise(size.x, size.y)}) {
      EXPECT_EQ(GetParam().decode(GetParam().encode(image), size), image);
    }
  }
}

TEST_P(EachDepthCodec, CompressesPlanes) {
  // Predicted, a plane has nothing left: a twentieth. PNG predicts each byte by itself.
  const size_t most = std::string(GetParam().name) == "png" ? 300 * 180 : 300 * 180 / 10;
  EXPECT_LT(GetParam().encode(depthOfDisc(300, 180)).size(), most);
}

TEST(ImageCodecs, AreFoundByName) {
  EXPECT_STREQ(findColorCodec("png")->mediaType, "image/png");
  EXPECT_STREQ(findDepthCodec("deflate")->mediaType, "application/zlib");
  EXPECT_EQ(findColorCodec("gif"), nullptr);
  EXPECT_EQ(findDepthCodec(""), nullptr);
}

TEST(ImageCodecs, JpegHasLimitsOfItsOwn) {
  const ColorCodec* codec = findColorCodec("jpeg");
  if (codec != nullptr) {  // this build may lack it
    EXPECT_THROW(codec->encode(Image<Rgb8>(65501, 1), 90), WorkError);
    EXPECT_GT(psnrAfter(*codec, coloredDisc(300, 180), 90), 30) << "the next one does not suffer";
  }
}

/// Its bytes are many times those that output begins with.
TEST(ImageCodecs, JpegOutputGrows) {
  const ColorCodec* codec = findColorCodec("jpeg");
  if (codec != nullptr) {
    const Image<Rgb8> image = colorNoise(500, 400);
    EXPECT_GT(codec->encode(image, 100).size(), size_t{1} << 18);
    EXPECT_GT(psnrAfter(*codec, image, 100), 40);  // rounded to 1 level in YCbCr and in frequencies: some 1.5 levels
  }
}

/// libjxl would make one of what is repeated. The decoder refuses them.
TEST(ImageCodecs, JpegXlNeedsNoHiddenFrames) {
  constexpr glm::ivec2 kSheet(256, 160);
  Image<Rgb8> sheet(kSheet.x, kSheet.y);
  for (int y = 0; y < kSheet.y; ++y) {
    for (int x = 0; x < kSheet.x; ++x) {
      const glm::ivec2 at(x % 20, y % 18);  // a ring in each cell
      const int out = std::max(std::abs(at.x - 9), std::abs(at.y - 9));
      sheet(x, y) = out == 3 ? Rgb8(0) : Rgb8(255);
    }
  }
  const ColorCodec* codec = findColorCodec("jxl");
  if (codec != nullptr) {  // this build may lack it
    EXPECT_EQ(codec->decode(codec->encode(sheet, 100), kSheet), sheet);
    EXPECT_GT(psnrAfter(*codec, sheet, 90), 30);
    for (double quality = 0; quality < 100; quality += 10) {  // coarse ones would have their averages in a hidden frame
      EXPECT_NO_THROW(psnrAfter(*codec, sheet, quality)) << quality;
    }
  }
}

TEST(ImageCodecs, JpegXlIsLosslessAtAHundred) {
  const Image<Rgb8> image = colorNoise(40, 30);
  const ColorCodec* codec = findColorCodec("jxl");
  if (codec != nullptr) {  // this build may lack it
    EXPECT_EQ(codec->decode(codec->encode(image, 100), {40, 30}), image);
  }
}

}  // namespace
}  // namespace ocelli
