#include "display_sim/gl/gl_volume.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::smallProfile;
using testing::HasSubstr;

class GlVolumeTest : public testing::TestWithParam<GlProvider> {
 protected:
  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlVolumeTest, kOffscreenProviders, providerName);

TEST_P(GlVolumeTest, comesBackAsItWent) {
  test::PointSource source(3);
  for (const int width : {2, 8, 13, 64}) {
    Volume volume(smallProfile(5, width, 7, SecondHalfTurn::kOwn));
    for (int i = 0; i < volume.slices(); ++i) {
      for (int row = 0; row < volume.height(); ++row) {
        for (int column = 0; column < width; ++column) {
          volume.light(i, column, row, static_cast<unsigned>(source.uniform(0, 8)));
        }
      }
    }
    EXPECT_GT(volume.litVoxels(), 0u);
    GlVolume onGpu(*context_, volume);
    EXPECT_EQ(onGpu.read(), volume);
    onGpu.clear();
    EXPECT_EQ(onGpu.read(), Volume(volume.profile()));
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

TEST_P(GlVolumeTest, startsDark) {
  const GlVolume volume(*context_, loadProfile("test"));
  EXPECT_EQ(volume.read(), Volume(loadProfile("test")));
}

// What the layout in gl_volume.h says, read as the shaders do.
TEST_P(GlVolumeTest, aWordHoldsEightVoxels) {
  Volume volume(smallProfile(3, 20, 4));
  volume.light(2, 13, 1, 5);
  const GlVolume onGpu(*context_, volume);
  std::vector<uint32_t> words(onGpu.wordCount());
  const GlScope scope(*context_);
  readBuffer(*context_, onGpu.words(), words.size() * sizeof(uint32_t), words.data());
  ASSERT_EQ(words.size(), 3u * 4 * 3);
  for (size_t i = 0; i < words.size(); ++i) {
    EXPECT_EQ(words[i], i == (2 * 4 + 1) * 3 + 1 ? 5u << 4 * 5 : 0u) << i;
  }
}

TEST_P(GlVolumeTest, aDisplayOfManyBitsIsBadInput) {
  DisplayProfile profile = smallProfile(4, 8, 8);
  profile.colorBitsPerChannel = 8;
  try {
    const GlVolume volume(*context_, profile);
    FAIL() << "made it";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("color_bits_per_channel of profile small"));
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

TEST_P(GlVolumeTest, aProfileTooLargeForTheGpuSaysSo) {
  DisplayProfile profile = smallProfile(4000, 1024, 1024);
  const int64_t bytes = int64_t{4000} * 128 * 1024 * 4;
  if (context_->info().maxStorageBytes >= bytes) {
    GTEST_SKIP() << "this GPU holds every volume of this size";
  }
  try {
    const GlVolume volume(*context_, profile);
    FAIL() << "made it";
  } catch (const GlError& error) {
    EXPECT_THAT(error.what(), HasSubstr("2000 MiB"));
    EXPECT_THAT(error.what(), HasSubstr("profile small"));
    EXPECT_THAT(error.what(), HasSubstr("without OpenGL"));
  }
  EXPECT_EQ(context_->liveObjects(), 0);
}

}  // namespace
}  // namespace ocelli
