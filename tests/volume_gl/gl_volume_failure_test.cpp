// Volumes that a context cannot hold, and contexts that fail: each error says what, where and what to do next, and
// nothing is left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "oc_core/gl/gl_api.h"
#include "oc_core/volume_gl/gl_volume_renderer.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/gl/gl_test_context.h"
#include "tests/render/camera_cases.h"
#include "tests/volume_render/test_volumes.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class GlVolumeFailureTest : public testing::TestWithParam<GlProvider> {
 protected:
  ~GlVolumeFailureTest() override { EXPECT_EQ(context_->liveObjects(), 0); }

  std::string messageOf(const std::function<void()>& work) {
    try {
      work();
    } catch (const GlError& error) {
      return error.what();
    }
    return "nothing was thrown";
  }
  /// The errors of this context do not end the test: they are what is tested.
  const std::unique_ptr<GlContext> context_ = openGlContext(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Providers, GlVolumeFailureTest, kOffscreenProviders, providerName);

TEST_P(GlVolumeFailureTest, aVolumeLongerThanTexturesIsRefused) {
  GLint most = 0;
  {
    const GlScope scope(*context_);
    context_->gl().GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most);
  }
  const VolumeScene scene = test::volumeOf<uint8_t>(
      {2, most + 1, 2}, 0.01, VoxelType::kUint8, [](const glm::dvec3&) { return 1; }, test::everywhere(0.5, 1));
  const std::string size = "2x" + std::to_string(most + 1) + "x2 voxels";
  EXPECT_THAT(messageOf([&] { GlVolumeRenderer(*context_, scene); }),
              AllOf(HasSubstr(size), HasSubstr(std::to_string(most) + "x"), HasSubstr(nameOf(GetParam())),
                    HasSubstr("\n  try: use a smaller volume")));
}

void GLAD_API_PTR noLevel(GLenum /*target*/, GLint /*level*/, GLenum /*name*/, GLint* value) {
  *value = 0;
}

TEST_P(GlVolumeFailureTest, aVolumeThatTheGpuHasNoRoomForIsRefused) {
  context_->functions().GetTexLevelParameteriv = noLevel;  // what a driver answers for a texture that it cannot hold
  EXPECT_THAT(messageOf([&] { GlVolumeRenderer(*context_, test::waves()); }),
              AllOf(HasSubstr("no room for a volume of 48x44x40 voxels"), HasSubstr("try: use a smaller volume")));
}

thread_local int memoryErrors = 0;

GLenum GLAD_API_PTR failForMemory() {
  return memoryErrors-- == 1 ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
}

TEST_P(GlVolumeFailureTest, aFullGpuIsReportedWhereverItFails) {
  VolumeScene scene = test::waves();
  const auto getError = context_->functions().GetError;
  // How many calls fail in turn, until one after the last is asked to.
  const auto failures = [&](const auto& camera) {
    context_->functions().GetError = failForMemory;
    int failing = 0;
    for (int call = 1;; ++call) {
      memoryErrors = call;
      try {
        const GlVolumeRenderer renderer(*context_, scene);
        renderVolumeOnGpu(camera, renderer);
        break;
      } catch (const GlError& error) {
        EXPECT_THAT(error.what(), HasSubstr("not enough memory"));
        EXPECT_EQ(context_->liveObjects(), 0);
        ++failing;
      }
    }
    context_->functions().GetError = getError;
    return failing;
  };
  const PinholeCamera camera(View{}, 8, 8);
  const int ofPinhole = failures(camera);
  EXPECT_GT(ofPinhole, 10) << "each step is checked";
  EXPECT_GT(failures(GpcCamera(camera, test::oneRegion("cubic"))), ofPinhole) << "its zones are uploaded, too";
  EXPECT_GT(failures(test::bendingTwice(camera)), 10) << "its pieces are";
  scene.surfaces.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  scene.surfaces.triangles = {{0, 1, 2}};
  EXPECT_GT(failures(camera), 10) << "so are those of rays that surfaces end";
}

GLenum GLAD_API_PTR reportReset() {
  return GL_INNOCENT_CONTEXT_RESET;
}

TEST_P(GlVolumeFailureTest, aLostContextIsReported) {
  GlVolumeRenderer renderer(*context_, test::waves());
  const auto status = context_->functions().GetGraphicsResetStatus;
  context_->functions().GetGraphicsResetStatus = reportReset;
  const auto isLost = AllOf(HasSubstr("context is lost"), HasSubstr("without OpenGL, on the CPU"));
  const PinholeCamera camera(View{}, 8, 8);
  EXPECT_THAT(messageOf([&] { renderer.render(camera); }), isLost);
  EXPECT_THAT(messageOf([&] { renderVolumeOnGpu(GpcCamera(camera, test::oneRegion("cubic")), renderer); }), isLost);
  EXPECT_THAT(messageOf([&] { renderVolumeOnGpu(test::bendingTwice(camera), renderer); }), isLost);
  EXPECT_THAT(messageOf([&] { renderer.setAppearance(test::waves(false).appearance); }), isLost);
  EXPECT_THAT(messageOf([&] { GlVolumeRenderer(*context_, test::waves()); }), isLost);
  context_->functions().GetGraphicsResetStatus = status;
}

}  // namespace
}  // namespace ocelli
