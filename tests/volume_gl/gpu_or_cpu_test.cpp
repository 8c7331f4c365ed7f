// The GPU where there is one, and else the CPU.
#include <gmock/gmock.h>

#include "oc_core/volume_gl/gpu_or_cpu_volume_renderer.h"
#include "tests/gl/gl_test_context.h"
#include "tests/volume_gl/volume_agreement.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

const PinholeCamera& smallPinhole() {
  static const PinholeCamera camera(View{}, 30, 20);
  return camera;
}

bool isSoftwareHere() {
  return openTestContext(GlProvider::kEgl)->info().isSoftware;
}

TEST(GpuOrCpuVolumeRenderer, drawsByOpenGlWhatTheCpuDraws) {
  VolumeScene scene = test::waves();
  GpuOrCpuVolumeRenderer renderer(scene, {}, VolumeDrawnBy::kOpenGlOrCpu);
  ASSERT_TRUE(renderer.isOnGpu());
  EXPECT_THAT(renderer.description(), testing::HasSubstr("through EGL"));
  test::expectAgreement(renderVolume(smallPinhole(), scene), renderer.render(smallPinhole()), "first");
  scene.appearance.shading.isOn = false;
  scene.clips = {{{1, 0, 0}, 0.1}};
  renderer.setAppearance(scene.appearance);
  renderer.setClips(scene.clips);
  renderer.setOptions({.step = 1});
  EXPECT_EQ(renderer.options().step, 1);
  EXPECT_EQ(renderer.scene().clips.size(), 1u);
  const auto ray = [](const glm::vec2& pixel) { return smallPinhole().rayPath(pixel); };
  test::expectAgreement(renderVolume(smallPinhole(), scene, {.step = 1}), renderer.render(30, 20, ray), "changed");
}

TEST(GpuOrCpuVolumeRenderer, aSoftwareRendererIsNoGpu) {
  const VolumeScene scene = test::waves();
  GpuOrCpuVolumeRenderer renderer(scene);
  ASSERT_EQ(renderer.isOnGpu(), !isSoftwareHere());
  if (!renderer.isOnGpu()) {
    EXPECT_EQ(renderer.description(), "the CPU");
    EXPECT_EQ(renderer.render(smallPinhole()), renderVolume(smallPinhole(), scene));
  }
}

// Longer than any 3-D texture along an axis.
TEST(GpuOrCpuVolumeRenderer, whatIsTooLargeForTheGpuIsDrawnByTheCpu) {
  VolumeScene scene = test::volumeOf<uint8_t>(
      {2, 2, 1 << 16}, 1.0 / (1 << 16), VoxelType::kUint8, [](const glm::dvec3&) { return 1; },
      test::everywhere(0.5, 0.001));
  GpuOrCpuVolumeRenderer renderer(scene, {.step = 100}, VolumeDrawnBy::kOpenGlOrCpu);
  EXPECT_FALSE(renderer.isOnGpu());
  EXPECT_EQ(renderer.render(smallPinhole()), renderVolume(smallPinhole(), scene, {.step = 100}));
}

}  // namespace
}  // namespace ocelli
