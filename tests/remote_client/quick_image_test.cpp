#include "oc_core/remote/client/quick_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "oc_core/base/parallel.h"
#include "tests/remote_client/client_scenes.h"

namespace ocelli {
namespace {

constexpr glm::ivec2 kSize{480, 270};

struct Differences {
  int most = 0;
  double mean = 0;   ///< bytes
  double share = 0;  ///< of pixels with a channel that differs by more than 8 bytes
};

Differences differencesOf(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  Differences differences;
  for (size_t i = 0; i < a.size(); ++i) {
    int most = 0;
    for (int c = 0; c < 3; ++c) {
      const int d = std::abs(a[i][c] - b[i][c]);
      most = std::max(most, d);
      differences.mean += d;
    }
    differences.most = std::max(differences.most, most);
    differences.share += most > 8;
  }
  differences.mean /= 3.0 * static_cast<double>(a.size());
  differences.share /= static_cast<double>(a.size());
  return differences;
}

Image<Rgb8> exactly(const ReferenceImage& image, const PinholeCamera& view) {
  return srgbFromLinear(resample({image}, view).color);
}

// Where no pixel stands for several samples both interpolate between the same four. What differs: the tables of the
// magnification (1e-3 pixels, which is a quarter of a byte at the sharpest edge) and of bytes (one), and rounding.
TEST(QuickImage, isTheExactPictureWhereSamplesAreInterpolated) {
  const ReferenceImage image = clientImage(clientView(14), kSize, clientLayout(2));
  const QuickImage quick(image);
  for (const View& view :
       {clientView(2.5), clientTurned(clientView(3), 1.2, -0.8), clientTurned(clientView(3), -3, 1.5)}) {
    const PinholeCamera camera(view, kSize.x, kSize.y);
    const Differences differences = differencesOf(quick.draw(camera).color, exactly(image, camera));
    EXPECT_LE(differences.most, 2);
    EXPECT_LE(differences.mean, 0.5);
  }
}

// Pixels that stand for more are means of about as many samples: of 1.5 where the exact picture takes 2.
TEST(QuickImage, isNearTheExactPictureWhereSamplesAreAveraged) {
  const ReferenceImage image = clientImage(clientView(14), kSize, clientLayout(3));
  const QuickImage quick(image);
  const PinholeCamera camera(clientView(13), kSize.x, kSize.y);
  const Differences differences = differencesOf(quick.draw(camera).color, exactly(image, camera));
  EXPECT_LE(differences.mean, 0.5);
  EXPECT_LE(differences.share, 0.02);
}

TEST(QuickImage, hasARegionsPlaceWhereverItIs) {
  const GpcLayout layout{findGpcSampling("quadratic"),
                         {{{0.25f, 0.3f}, {0.2f, 0.2f}, 3, 1}, {{0.75f, 0.7f}, {0.2f, 0.3f}, 2, 0.5f}}};
  const ReferenceImage image = clientImage(clientView(12), kSize, layout);
  const PinholeCamera camera(clientTurned(clientView(4), -2.5, 1.2), kSize.x, kSize.y);
  EXPECT_LE(differencesOf(QuickImage(image).draw(camera).color, exactly(image, camera)).most, 2);
}

// From beside, the surfaces of the exact picture are made of its samples, these of flat pieces: they differ at rims, by
// a pixel or so.
TEST(QuickImage, isNearTheExactPictureFromBeside) {
  const ReferenceImage image = clientImage(clientView(14), kSize, clientLayout(2));
  const QuickImage quick(image);
  const View beside = movedEye(clientView(11), {0.4f, 0.2f, 0.3f});
  const PinholeCamera camera(beside, kSize.x, kSize.y);
  const QuickFrame frame = quick.draw(camera);
  EXPECT_TRUE(frame.isWarped);
  const Differences warped = differencesOf(frame.color, exactly(image, camera));
  // What it would show without depth, as a measure of what this must be better than.
  const Differences flat = differencesOf(QuickImage(image, false).draw(camera).color, exactly(image, camera));
  EXPECT_LE(warped.share, 0.05);
  EXPECT_LE(warped.share, flat.share / 3);
}

TEST(QuickImage, fillsWhatWasHiddenWithWhatLiesBehind) {
  // A small bright square before a large dark wall.
  Mesh mesh;
  const auto square = [&](float half, float z, const glm::vec3& color) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::vec2& corner :
         {glm::vec2(-half, -half), glm::vec2(half, -half), glm::vec2(half, half), glm::vec2(-half, half)}) {
      mesh.positions.emplace_back(corner, z);
      mesh.colors.push_back(color);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  };
  square(3, 0, {0, 0, 0.5f});
  square(0.3f, 2, {1, 0, 0});
  const ReferenceImage image = clientImage(clientView(20), {300, 200}, {.regions = {}}, mesh);
  const QuickImage quick(image);
  const PinholeCamera camera(movedEye(clientView(14), {1, 0, 0}), 300, 200);
  const QuickFrame frame = quick.draw(camera);
  // The square hides 0.3 * 2 * (10 / 8) of the wall's width; seen from 1 to the right, a strip of it comes into view
  // that is as wide as the square has moved before the wall: 1 * 2 / 8, and as high as the square.
  const double pixels = 1.0 * 2 / 8 * 0.6 * 10 / 8 * std::pow(static_cast<double>(camera.focalPixels()) / 10, 2);
  EXPECT_NEAR(frame.holes * 300 * 200, pixels, 0.15 * pixels);
  size_t red = 0;
  for (const Rgb8& c : frame.color) {
    red += c.x > 128;
  }
  // And it is no wider than it was.
  const double seen = std::pow(0.6 * static_cast<double>(camera.focalPixels()) / std::hypot(8.0, 0.8), 2);
  EXPECT_NEAR(static_cast<double>(red), seen, 0.15 * seen);
}

TEST(QuickImage, isTheSameWithAnyNumberOfThreads) {
  const ReferenceImage image = clientImage(clientView(14), kSize, clientLayout(2));
  const PinholeCamera camera(movedEye(clientView(11), {0.4f, 0.2f, 0.3f}), kSize.x, kSize.y);
  const Image<Rgb8> together = QuickImage(image).draw(camera).color;
  Image<Rgb8> alone;
  runAlone([&] { alone = QuickImage(image).draw(camera).color; });
  EXPECT_EQ(together, alone);
}

}  // namespace
}  // namespace ocelli
