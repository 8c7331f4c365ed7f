// The GPU slicer against slice() and the definition.
#include "display_sim/gl/gl_slicer.h"

#include <gtest/gtest.h>

#include "tests/display_sim/test_meshes.h"
#include "tests/display_sim/test_profiles.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

using test::smallProfile;

class GlSlicerTest : public testing::TestWithParam<GlProvider> {
 protected:
  Volume sliced(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options = {}) {
    const GlScope scope(*context_);
    const GlMesh onGpu(*context_, mesh);
    GlVolume volume(*context_, profile);
    slicer_.slice(onGpu, volume, options);
    return volume.read();
  }

  const std::unique_ptr<GlContext> context_ = openTestContext(GetParam());
  GlSlicer slicer_{*context_};
};
INSTANTIATE_TEST_SUITE_P(Providers, GlSlicerTest, kOffscreenProviders, providerName);

TEST_P(GlSlicerTest, torus) {
  const Mesh mesh = test::torus(0.6, 0.3, 90, 40);
  const DisplayProfile profile = smallProfile(48, 80, 80);
  const Volume a = slice(mesh, profile);
  const Volume b = sliced(mesh, profile);
  EXPECT_EQ(a.litVoxels(), b.litVoxels());
  EXPECT_EQ(a, b);
}

}  // namespace
}  // namespace ocelli
