// Textures of files, seen face-on at one pixel a texel, beside the texture itself.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "oc_core/base/random.h"
#include "tests/base/temporary_folder.h"
#include "tests/render/file_pictures.h"

namespace ocelli {
namespace {

using test::Picture;
using test::pictureOfFile;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kImageSide = 160;
constexpr int kTextureSide = 128;

using TexelOf = std::function<Rgb8(int x, int y)>;

/// Waves as fine as eight texels, as most of a photograph has.
Rgb8 softTexel(int x, int y) {
  const auto wave = [&](double length, double slope) {
    return static_cast<uint8_t>(std::lround(127.5 + 120 * std::sin(2 * 3.14159265 * (x + slope * y) / length)));
  };
  return {wave(8, 0.3), wave(20, -1), wave(50, 0.7)};
}

/// A square with a texture, which fills so many pixels of the picture as the texture has texels.
class FaceOnSquare {
 public:
  explicit FaceOnSquare(const TexelOf& texel) : image_(kTextureSide, kTextureSide) {
    for (int y = 0; y < kTextureSide; ++y) {
      for (int x = 0; x < kTextureSide; ++x) {
        image_(x, y) = texel(x, y);
      }
    }
    writePng(folder_.path() / "t.png", image_);
    folder_.write("a.mtl", "newmtl tex\nKd 1 1 1\nmap_Kd t.png\n");
    const PinholeCamera camera(View{}, kImageSide, kImageSide);
    const double pixels = static_cast<double>(camera.project(glm::vec3(1, 0, 0))->u - camera.project(glm::vec3(0))->u);
    const double half = kTextureSide / 2.0 / pixels;
    path_ = folder_.write("a.obj", fmt::format("mtllib a.mtl\nv {0} {0} 0\nv {1} {0} 0\nv {1} {1} 0\nv {0} {1} 0\n"
                                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl tex\nf 1/1 2/2 3/3 4/4\n",
                                               -half, half));
  }

  /// Mean difference in levels of 255, of all pixels but those along the rim.
  double error(size_t triangles, const std::string& name) {
    warnings.clear();
    SceneOptions options{.fit = false, .shading = Shading::kNone, .textureTriangles = triangles};
    options.warn = [&](const std::string& warning) { warnings.push_back(warning); };
    const Image<Rgb8> seen = srgbFromLinear(pictureOfFile(path_, options, name, kImageSide));
    constexpr int kRim = (kImageSide - kTextureSide) / 2;
    int sum = 0;
    for (int y = 1; y + 1 < kTextureSide; ++y) {
      for (int x = 1; x + 1 < kTextureSide; ++x) {
        for (glm::length_t i = 0; i < 3; ++i) {
          sum += std::abs(int{seen(x + kRim, y + kRim)[i]} - int{image_(x, y)[i]});
        }
      }
    }
    return sum / 3.0 / ((kTextureSide - 2) * (kTextureSide - 2));
  }

  std::vector<std::string> warnings;

 private:
  TemporaryFolder folder_;
  Image<Rgb8> image_;
  std::filesystem::path path_;
};

TEST(TexturePictures, AreTheTextureItselfWhereItIsWhole) {
  Random random(1);
  const auto noise = [&](int, int) {
    const auto level = [&] { return static_cast<uint8_t>(random.below(256)); };
    const uint8_t red = level();
    const uint8_t green = level();
    return Rgb8(red, green, level());
  };
  for (const auto& [texel, name] : {std::pair<TexelOf, std::string>{softTexel, "soft"}, {noise, "noise"}}) {
    FaceOnSquare square(texel);
    // Half a level: the texture has bytes, as the picture has, and a vertex stands at the middle of each pixel, to some
    // roundings of where it is seen.
    const double whole = square.error(kUsualTextureTriangles, "texture_whole_" + name);
    EXPECT_LT(whole, 0.5) << name;
    EXPECT_THAT(square.warnings, IsEmpty());
    const double coarse = square.error(2 * kTextureSide * kTextureSide, "texture_coarse_" + name);
    EXPECT_THAT(square.warnings, IsEmpty());
    const double halved = square.error(kTextureSide * kTextureSide, "texture_halved_" + name);
    EXPECT_THAT(square.warnings,
                ElementsAre(AllOf(HasSubstr("1/2"), HasSubstr("32766"), HasSubstr("--texture-triangles full"))));
    EXPECT_LT(whole, coarse);
    EXPECT_LT(coarse, halved);
    fmt::print("{}: mean difference in levels: eight triangles a pixel {:.2f}, two {:.2f}, halved {:.2f}\n", name,
               whole, coarse, halved);
  }
}

}  // namespace
}  // namespace ocelli
