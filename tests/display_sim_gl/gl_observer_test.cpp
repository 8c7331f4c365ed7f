// The GPU observer against collectLight().
#include "display_sim/gl/gl_observer.h"

#include <gmock/gmock.h>

#include <cmath>

#include "oc_core/base/error.h"
#include "tests/display_sim_dither/light_measures.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::smallProfile;
using test::sumOf;
using testing::HasSubstr;

class GlObserverTest : public testing::TestWithParam<GlProvider> {
 protected:
  Image<glm::vec3> observed(const Volume& volume, const GlObserverOptions& options) {
    const GlVolume onGpu(*context_, volume);
    observer_.look(onGpu);
    observer_.draw(options);
    return observer_.readLight();
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
  GlObserver observer_{*context_};
};
INSTANTIATE_TEST_SUITE_P(Providers, GlObserverTest, kOffscreenProviders, providerName);

/// Sums of squares of pixels of this side: what a blur leaves.
Image<glm::vec3> blocks(const Image<glm::vec3>& image, int side) {
  Image<glm::vec3> sums(image.width() / side, image.height() / side, glm::vec3(0));
  for (int y = 0; y < sums.height() * side; ++y) {
    for (int x = 0; x < sums.width() * side; ++x) {
      sums(x / side, y / side) += image(x, y);
    }
  }
  return sums;
}

/// Of their pixels, relative to the light of both.
double difference(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  glm::dvec3 sum(0);
  for (size_t i = 0; i < a.size(); ++i) {
    sum += glm::dvec3(glm::abs(a[i] - b[i]));
  }
  const glm::dvec3 light = sumOf(a) + sumOf(b);
  return 2 * (sum.x + sum.y + sum.z) / (light.x + light.y + light.z);
}

struct NamedView {
  const char* name;
  ObserverOptions options;
};

std::vector<NamedView> views() {
  return {{"default", {.width = 300, .height = 200}},
          {"large", {.width = 900, .height = 900}},
          {"from above", {.eye = {0, 7, 0}, .width = 150, .height = 200}},
          {"oblique", {.eye = {3, 4, -2}, .width = 200, .height = 200}},
          {"close", {.eye = {1.2f, 0.3f, 0.4f}, .width = 200, .height = 200, .fovVerticalDegrees = 60}},
          {"a part of the display", {.eye = {0, 1, 5}, .width = 200, .height = 100, .fovVerticalDegrees = 5}},
          {"a sector is missing",
           {.width = 200, .height = 200, .exposureSeconds = 1.0 / 25, .missingSectorStartDegrees = 33}},
          {"a long exposure", {.width = 200, .height = 200, .exposureSeconds = 100.0 / 7}},
          {"few pixels", {.width = 5, .height = 3}},
          {"a screen", {.eye = {3, 4, -2}, .width = 200, .height = 200, .emission = {.model = EmissionModel::kScreen}}},
          {"a screen with a dim back",
           {.width = 200,
            .height = 200,
            .exposureSeconds = 1.3 / 24,
            .startDegrees = 50,
            .emission = {.model = EmissionModel::kScreen, .transmission = 0.2}}},
          {"a wobble",
           {.eye = {3, 4, -2},
            .width = 200,
            .height = 200,
            .exposureSeconds = 3.0 / 24,
            .wobble = {.amplitudeRadii = 0.1, .direction = {1, 2, 3}, .frequency = 1.25, .phaseDegrees = 40}}},
          {"a dead zone", {.width = 200, .height = 200, .deadZoneRadii = 0.5}}};
}

// The same parts in single precision: their borders move by about 1e-4 pixels, of boxes about a pixel large; a part
// that is rounded to a length of just more or less than a pixel is divided otherwise. The sums of whole numbers round a
// share of light, one hundredth of a voxel's or more, by 2^-21.
TEST_P(GlObserverTest, seesWhatTheCpuSees) {
  for (const SecondHalfTurn half : {SecondHalfTurn::kMirrored, SecondHalfTurn::kOwn}) {
    const Volume volume = test::coloredTorus(smallProfile(24, 50, 64, half));
    for (const NamedView& view : views()) {
      SCOPED_TRACE(view.name);
      const Image<glm::vec3> CPUs = collectLight(volume, view.options);
      const Image<glm::vec3> image = observed(volume, {.view = view.options});
      ASSERT_EQ(image.size(), CPUs.size());
      const glm::dvec3 sum = sumOf(CPUs);
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_GT(sum[channel], 1);
        EXPECT_NEAR(sumOf(image)[channel] / sum[channel], 1, 1e-3);
      }
      EXPECT_LE(difference(image, CPUs), 1e-3);
    }
  }
}

TEST_P(GlObserverTest, channelsInTurnAreThoseOfTheCpu) {
  DisplayProfile profile = smallProfile(24, 50, 64);
  profile.channelTiming = ChannelTiming::kInTurn;
  const Volume volume = test::coloredTorus(profile);
  const ObserverOptions view{.eye = {3, 4, -2}, .width = 200, .height = 200, .exposureSeconds = 1.0 / 25};
  const Image<glm::vec3> CPUs = collectLight(volume, view);
  const Image<glm::vec3> image = observed(volume, {.view = view});
  EXPECT_GT(sumOf(CPUs).y, 1);
  EXPECT_LE(difference(image, CPUs), 1e-3);
}

// Points lie within a pixel of where the light is: blocks of 10 x 10 pixels trade some of that along their borders.
TEST_P(GlObserverTest, pointsAreTheSameLightBlurred) {
  const Volume volume = test::coloredTorus(smallProfile(48, 100, 100));
  const ObserverOptions view{.eye = {3, 4, -2}, .width = 300, .height = 300};
  const Image<glm::vec3> CPUs = collectLight(volume, view);
  const Image<glm::vec3> image = observed(volume, {.view = view, .splat = GlSplat::kPoints});
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(sumOf(image)[channel] / sumOf(CPUs)[channel], 1, 1e-3);
  }
  EXPECT_LE(difference(blocks(image, 10), blocks(CPUs, 10)), 0.05);
  EXPECT_GT(difference(image, CPUs), 0.05) << "boxes were drawn";
}

TEST_P(GlObserverTest, aWindowShowsAPartOfTheSweep) {
  const DisplayProfile profile = smallProfile(20, 32, 32);
  Volume volume(profile);
  volume.light(3, 27, 12, 1);
  volume.light(4, 27, 12, 2);
  const double step = kPi / 20;
  const ObserverOptions view{.width = 100, .height = 100};
  const auto light = [&](const SweepWindow& window) {
    return sumOf(observed(volume, {.view = view, .window = window}));
  };
  const glm::dvec3 all = sumOf(observed(volume, {.view = view}));
  const glm::dvec3 whole = light({.endRadians = 19.5 * step, .sweptRadians = kPi});
  const glm::dvec3 third = light({.endRadians = 3.5 * step, .sweptRadians = step});
  const glm::dvec3 half = light({.endRadians = 4 * step, .sweptRadians = step});
  const glm::dvec3 twice = light({.endRadians = 19.5 * step, .sweptRadians = 2 * kPi});
  EXPECT_NEAR(whole.x, all.x, 1e-5 * all.x);
  EXPECT_NEAR(third.x, all.x, 1e-5 * all.x);
  EXPECT_EQ(third.y, 0);
  EXPECT_NEAR(half.x, all.x / 2, 0.02 * all.x) << "the other half of the arc is nearer or farther";
  EXPECT_NEAR(half.y, all.y / 2, 0.02 * all.y);
  EXPECT_NEAR(twice.y, 2 * all.y, 1e-5 * all.y);
  EXPECT_EQ(light({.endRadians = 9 * step, .sweptRadians = step}), glm::dvec3(0));
  EXPECT_EQ(light({.endRadians = 3 * step, .sweptRadians = 0}), glm::dvec3(0));
}

// The light of 98,304 voxels in one pixel is more than 32 bits of 2^-20 hold, and they are more than the list's room.
TEST_P(GlObserverTest, carriesAndGrows) {
  const DisplayProfile profile = smallProfile(96, 110, 110);
  Volume volume(profile);
  for (int i = 0; i < volume.slices(); ++i) {
    std::ranges::fill(volume.slice(i), uint8_t{0});
    for (int row = 0; row < volume.height(); ++row) {
      for (int column = 0; column < volume.width(); ++column) {
        volume.light(i, column, row, column % 2 == 0 ? 7 : 1);
      }
    }
  }
  const ObserverOptions view{.width = 1, .height = 1};
  const glm::dvec3 CPUs = sumOf(collectLight(volume, view));
  const glm::dvec3 sum = sumOf(observed(volume, {.view = view}));
  EXPECT_EQ(observer_.litVoxels(), size_t{96} * 110 * 110);
  EXPECT_GT(CPUs.y, 1e5);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(sum[channel] / CPUs[channel], 1, 1e-3);
  }
}

TEST_P(GlObserverTest, looksAgainAndResizes) {
  const DisplayProfile profile = smallProfile(20, 32, 32);
  const GlVolume sphere(*context_, sliceExactly(test::sphere(0.7, 12), profile));
  const GlVolume dark(*context_, profile);
  observer_.look(sphere);
  observer_.draw({.view = {.width = 60, .height = 40}});
  const Image<glm::vec3> first = observer_.readLight();
  observer_.draw({.view = {.width = 30, .height = 20}});
  EXPECT_EQ(observer_.readLight().width(), 30);
  observer_.draw({.view = {.width = 60, .height = 40}});
  EXPECT_EQ(observer_.readLight(), first) << "nothing is left of frames before";
  observer_.look(dark);
  EXPECT_EQ(observer_.litVoxels(), 0u);
  observer_.draw({.view = {.width = 60, .height = 40}});
  EXPECT_EQ(sumOf(observer_.readLight()), glm::dvec3(0));
}

TEST_P(GlObserverTest, badOptionsAreErrors) {
  const GlVolume volume(*context_, smallProfile(4, 8, 8));
  observer_.look(volume);
  EXPECT_THROW(observer_.draw({.view = {.eye = {0, 0, 0.5f}}}), InputError);
  EXPECT_THROW(observer_.draw({.view = {.width = 0}}), InputError);
  EXPECT_THROW(observer_.draw({.view = {}, .window = SweepWindow{.sweptRadians = -1}}), InputError);
  for (const ObserverOptions& view : {ObserverOptions{.lens = {.apertureRadii = 0.1}}, ObserverOptions{.ambient = 1}}) {
    try {
      observer_.draw({.view = view});
      FAIL() << "drew it";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("without OpenGL"));
    }
  }
  try {
    observer_.draw({.view = {.width = 1 << 20, .height = 1 << 6}});
    FAIL() << "drew it";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("without OpenGL"));
  }
  observer_.draw({.view = {.width = 8, .height = 8}});
  EXPECT_EQ(sumOf(observer_.readLight()), glm::dvec3(0)) << "it goes on working";
}

TEST_P(GlObserverTest, anEyeCloseByIsSafe) {
  const Volume volume = sliceExactly(test::sphere(0.99, 20), smallProfile(20, 32, 32));
  for (const glm::vec3& pixel : observed(volume, {.view = {.eye = {1.01f, 0, 0}, .width = 64, .height = 64}})) {
    EXPECT_TRUE(std::isfinite(pixel.x));
  }
}

// Voxels at the axis, seen from straight above, have no extent along the sweep.
TEST_P(GlObserverTest, lightWithoutExtentIsNotLost) {
  Volume volume(smallProfile(4, 9, 9));
  volume.light(0, 4, 4, 7);
  const Image<glm::vec3> image = observed(volume, {.view = {.eye = {0, 7, 0}, .width = 61, .height = 61}});
  EXPECT_NEAR(sumOf(image).x, 1, 1e-3);  // it stands at the centre, where light is not scaled by distance
  EXPECT_GT(image(30, 30).x, 0);
}

TEST_P(GlObserverTest, moreLitVoxelsThanTheGpuListsSaySo) {
  const DisplayProfile profile = loadProfile("perspecta");
  Volume volume(profile);
  for (int i = 0; i < volume.slices(); ++i) {
    std::ranges::fill(volume.slice(i), uint8_t{0xff});  // no padding: its width is a multiple of 8
  }
  if (static_cast<size_t>(context_->info().maxStorageBytes) / sizeof(uint32_t) > volume.litVoxels() + 2) {
    GTEST_SKIP() << "this GPU lists all of them";
  }
  const GlVolume onGpu(*context_, volume);
  try {
    observer_.look(onGpu);
    FAIL() << "listed them";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("116785152 voxels are lit"));
    EXPECT_THAT(error.what(), HasSubstr("without OpenGL"));
  }
  const GlVolume dark(*context_, smallProfile(4, 8, 8));
  observer_.look(dark);
  EXPECT_EQ(observer_.litVoxels(), 0u) << "it goes on working";
}

TEST(GlObserverTest, providersAgreeAndNothingIsLeftBehind) {
  const Volume volume = test::coloredTorus(smallProfile(48, 100, 100));
  std::vector<Image<glm::vec3>> images;
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa}) {
    const auto context = openTestContext(provider);
    if (!context->info().isSoftware) {
      GTEST_SKIP() << "another renderer than OSMesa's";
    }
    {
      GlObserver observer(*context);
      const GlVolume onGpu(*context, volume);
      observer.look(onGpu);
      for (const GlSplat splat : {GlSplat::kBoxes, GlSplat::kPoints}) {
        observer.draw({.view = {.eye = {3, 4, -2}, .width = 200, .height = 200}, .splat = splat});
        images.push_back(observer.readLight());
      }
    }
    EXPECT_EQ(context->liveObjects(), 0);
  }
  EXPECT_EQ(images[0], images[2]);
  EXPECT_EQ(images[1], images[3]);
}

}  // namespace
}  // namespace ocelli
