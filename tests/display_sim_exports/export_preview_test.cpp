#include "display_sim/exports/export_preview.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "display_sim/exports/export_apng.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_writer.h"
#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_exports/animated_png.h"
#include "tests/display_sim_observing/recorded_frames.h"
#include "tests/display_sim_slicing/test_meshes.h"

namespace ocelli {
namespace {

using test::AnimatedPng;
using test::coloredTorus;
using test::fileBytes;
using test::readAnimatedPng;
using test::recordedProfile;
using test::recordedVolume;
using test::smallProfile;
using test::TemporaryFolder;
using ::testing::ElementsAre;

Image<Rgb8> randomImage(int width, int height, uint32_t seed) {
  test::PointSource source(seed);
  Image<Rgb8> image(width, height, Rgb8(0));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Rows of noise, of one colour, of a slope along the row, and of a copy of the row above: each wants its filter.
      const auto noise = static_cast<uint8_t>(source.uniform(0, 255));
      const auto slope = static_cast<uint8_t>(7 * x + y);
      const Rgb8 kinds[] = {Rgb8(noise, slope, noise), Rgb8(9, 8, 7), Rgb8(slope), y > 0 ? image(x, y - 1) : Rgb8(0)};
      image(x, y) = kinds[y % 4];
    }
  }
  return image;
}

TEST(ExportApng, holdsTheImagesAndTheirTimes) {
  const TemporaryFolder folder;
  std::vector<Image<Rgb8>> images;
  ApngWriter writer(folder / "a.png", 31, 17, 3);
  for (uint32_t i = 0; i < 3; ++i) {
    images.push_back(randomImage(31, 17, i));
    writer.add(images.back(), static_cast<uint16_t>(300 * i + 20));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
  writer.finish();
  const AnimatedPng animation = readAnimatedPng(fileBytes(folder / "a.png"));
  EXPECT_EQ(animation.images, images);
  EXPECT_THAT(animation.milliseconds, ElementsAre(20, 320, 620));
  EXPECT_EQ(readPng(folder / "a.png"), images.front()) << "what a reader without animations shows";
}

/// Where the light of an image is on average, in pixels from its middle: to the right, and upwards.
glm::dvec2 middleOfLight(const Image<glm::vec3>& light) {
  glm::dvec2 sum(0);
  double total = 0;
  for (int y = 0; y < light.height(); ++y) {
    for (int x = 0; x < light.width(); ++x) {
      sum += static_cast<double>(light(x, y).x) * glm::dvec2(x + 0.5, y + 0.5);
      total += light(x, y).x;
    }
  }
  return {sum.x / total - light.width() / 2.0, light.height() / 2.0 - sum.y / total};
}

TEST(ExportPreview, aVoxelShowsWhereItIs) {
  const DisplayProfile profile = smallProfile(90, 64, 64);
  const SweepGeometry sweep(profile);
  Volume volume(profile);
  volume.light(20, 50, 10, 1);
  const glm::dvec3 p = sweep.voxelCenter(20, 50, 10);
  for (const double turn : {0.0, 1.0, 2.5, 4.0}) {
    const Image<glm::vec3> light = projectedLight(volume, {.turnRadians = turn, .reachRadii = 1.25}, 200);
    // Along z turned towards x, right is x turned towards -z; 80 pixels are a radius.
    const double right = p.x * std::cos(turn) - p.z * std::sin(turn);
    const double towards = p.x * std::sin(turn) + p.z * std::cos(turn);
    const glm::dvec2 seen = middleOfLight(light);
    // The arc of a cell is 2.2 pixels long, and bent; light is split between pixels in proportion.
    EXPECT_NEAR(seen.x, 80 * right, 0.1) << turn;
    EXPECT_NEAR(seen.y, 80 * (p.y * std::cos(0.2) - towards * std::sin(0.2)), 0.1) << turn;
  }
}

TEST(ExportPreview, nearLightIsBrighterThanFarAndLevelsCount) {
  DisplayProfile profile = smallProfile(90, 64, 64);
  profile.colorBitsPerChannel = 2;
  const auto total = [&](int column, uint8_t level, double turn) {
    Volume volume(profile);
    volume.raise(45, column, 32, Rgb8(0, level, 0));
    float sum = 0;
    for (const glm::vec3& pixel : projectedLight(volume, {.turnRadians = turn, .reachRadii = 1.25}, 100)) {
      EXPECT_EQ(pixel.x, 0);
      sum += pixel.y;
    }
    return sum;
  };
  // Slice 45 of 90 lies along z: the right end is near at first, and far after half a turn.
  EXPECT_GT(total(63, 3, 0), 2 * total(63, 3, kPi));
  EXPECT_NEAR(total(63, 1, 0) / total(63, 3, 0), 1.0 / 3, 1e-4);
}

TEST(ExportPreview, theReachHoldsEveryTurn) {
  const Volume volume = coloredTorus(smallProfile(30, 64, 64));
  const double reach = previewReach(volume);
  EXPECT_GT(reach, 0.8);
  for (double turn = 0; turn < 2 * kPi; turn += 0.7) {
    const Image<glm::vec3> light = projectedLight(volume, {.turnRadians = turn, .reachRadii = 1.05 * reach}, 64);
    for (int i = 0; i < 64; ++i) {
      for (const glm::vec3& pixel : {light(i, 0), light(i, 63), light(0, i), light(63, i)}) {
        EXPECT_EQ(pixel, glm::vec3(0)) << turn;
      }
    }
  }
  EXPECT_EQ(previewReach(Volume(smallProfile(4, 8, 8))), 0);
}

TEST(ExportPreview, aVolumeTurnsAroundOnce) {
  const TemporaryFolder folder;
  writeSvol(folder / "a.svol", coloredTorus(smallProfile(12, 16, 16)));
  SvolReader reader(folder / "a.svol");
  exportPreview(folder / "a.png", reader, {.pixels = 40});
  const AnimatedPng animation = readAnimatedPng(fileBytes(folder / "a.png"));
  ASSERT_EQ(animation.images.size(), 60u);
  EXPECT_NEAR(std::accumulate(animation.milliseconds.begin(), animation.milliseconds.end(), 0), 5000, 60);
  EXPECT_NE(animation.images[0], animation.images[15]);
  EXPECT_TRUE(std::ranges::any_of(animation.images[0], [](const Rgb8& pixel) { return pixel.x > 100; }));
}

TEST(ExportPreview, aRecordingPlaysAtItsOwnSpeed) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 16, 16, 1);
  {
    SvolWriter writer(folder / "a.svol", profile);
    for (uint32_t k = 0; k < 3; ++k) {
      writer.append(recordedVolume(profile, k), k * k * 100000);
    }
    writer.finish();
  }
  SvolReader reader(folder / "a.svol");
  exportPreview(folder / "a.png", reader, {.pixels = 40});
  const auto refresh = static_cast<int>(std::lround(1000 / profile.refreshHertz()));
  const AnimatedPng animation = readAnimatedPng(fileBytes(folder / "a.png"));
  EXPECT_THAT(animation.milliseconds, ElementsAre(100, 300, std::max(refresh, 20)));
}

TEST(ExportPreview, longRecordingsAreShortenedAndDarkOnesAreBlack) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 16, 16, 1);
  {
    SvolWriter writer(folder / "a.svol", profile);
    for (uint32_t k = 0; k < 240; ++k) {
      writer.append(Volume(profile), k * 50000);
    }
    writer.finish();
  }
  SvolReader reader(folder / "a.svol");
  exportPreview(folder / "a.png", reader, {.pixels = 16});
  const AnimatedPng animation = readAnimatedPng(fileBytes(folder / "a.png"));
  EXPECT_EQ(animation.images.size(), 120u);
  EXPECT_EQ(animation.milliseconds.front(), 100);
  EXPECT_EQ(animation.images.back(), Image<Rgb8>(16, 16, Rgb8(0)));
}

TEST(ExportPreview, hasTheSameBytesWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  writeSvol(folder / "a.svol", coloredTorus(smallProfile(12, 16, 16)));
  SvolReader reader(folder / "a.svol");
  setThreadCount(1);
  exportPreview(folder / "one.png", reader, {.pixels = 40});
  setThreadCount(8);
  exportPreview(folder / "eight.png", reader, {.pixels = 40});
  setThreadCount(0);
  EXPECT_EQ(fileBytes(folder / "one.png"), fileBytes(folder / "eight.png"));
}

TEST(ExportPreview, aSizeOutOfRangeOrAFileWithoutFramesIsAnInputError) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 16, 16, 1);
  writeSvol(folder / "a.svol", Volume(profile));
  SvolReader reader(folder / "a.svol");
  EXPECT_THROW(exportPreview(folder / "a.png", reader, {.pixels = 15}), InputError);
  EXPECT_THROW(exportPreview(folder / "a.png", reader, {.pixels = 2049}), InputError);
  SvolWriter(folder / "b.svol", profile).finish();
  SvolReader empty(folder / "b.svol");
  EXPECT_THROW(exportPreview(folder / "a.png", empty), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

}  // namespace
}  // namespace ocelli
