// Images come out as they went in, or scaled.
#include "study/views/kept_image.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"
#include "oc_core/image/color.h"
#include "oc_core/render/identity_image.h"

namespace ocelli::test {
namespace {

TEST(KeptImage, GivesTheSameBytesAtItsSize) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const int width = 1 + static_cast<int>(random.below(40));
    const int height = 1 + static_cast<int>(random.below(40));
    Image<Rgb8> pixels(width, height, Rgb8(0));
    Image<uint32_t> objects(width, height, kNothing);
    for (size_t lit = random.below(pixels.size()); lit > 0; --lit) {
      const size_t at = random.below(pixels.size());
      pixels[at] = Rgb8(glm::uvec3(random.below(256), random.below(256), random.below(256)));
      objects[at] = random.below(2) == 0 ? kNothing : 1 + static_cast<uint32_t>(random.below(3));
    }
    const ShownImage shown = KeptImage(pixels, objects).at({width, height});
    EXPECT_EQ(shown.pixels, pixels);
    EXPECT_EQ(shown.objects, objects);
  }
}

TEST(KeptImage, OfNothingIsDark) {
  const KeptImage kept(Image<Rgb8>(5, 4, Rgb8(0)), Image<uint32_t>(5, 4, kNothing));
  EXPECT_EQ(kept.at({10, 8}).pixels, Image<Rgb8>(10, 8, Rgb8(0)));
  EXPECT_LE(kept.bytes(), sizeof(KeptImage));
}

// Of two pixels, black and white, four: those at the ends are theirs, the others a quarter and three quarters.
TEST(KeptImage, InterpolatesWhereItIsScaled) {
  Image<Rgb8> pixels(2, 1, Rgb8(0));
  pixels(1, 0) = Rgb8(200);
  Image<uint32_t> objects(2, 1, kNothing);
  objects(1, 0) = 7;
  const ShownImage shown = KeptImage(pixels, objects).at({4, 1});
  const float light = linearFromSrgbByte(200);
  const std::vector<int> expected{0, srgbByteFromLinear(light / 4), srgbByteFromLinear(light * 3 / 4), 200};
  for (int x = 0; x < 4; ++x) {
    EXPECT_EQ(shown.pixels(x, 0).x, expected[static_cast<size_t>(x)]);
    EXPECT_EQ(shown.objects(x, 0), x < 2 ? kNothing : 7u);
  }
}

// Scaled by a whole factor the mean stays, but for rounding: bytes of bright light are up to a percent apart.
TEST(KeptImage, KeepsTheLightWhereItIsScaled) {
  Random random(5);
  Image<Rgb8> pixels(30, 20, Rgb8(0));
  for (int y = 5; y < 15; ++y) {
    for (int x = 8; x < 19; ++x) {
      pixels(x, y) = Rgb8(glm::uvec3(static_cast<unsigned>(random.below(256))));
    }
  }
  const auto meanOf = [](const Image<Rgb8>& image) {
    double sum = 0;
    for (const Rgb8& pixel : image) {
      sum += static_cast<double>(linearFromSrgbByte(pixel.x));
    }
    return sum / static_cast<double>(image.size());
  };
  const KeptImage kept(pixels, Image<uint32_t>(30, 20, kNothing));
  EXPECT_NEAR(meanOf(kept.at({90, 60}).pixels), meanOf(pixels), 0.005 * meanOf(pixels));
}

}  // namespace
}  // namespace ocelli::test
