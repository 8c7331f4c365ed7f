// The GPU slicer at the size of the reference display: scanned objects, from $OCELLI_DATA_DIR, and an OCRI's mesh.
#include <gtest/gtest.h>

#include <cstdlib>

#include "display_sim/gl/gl_slicer.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/display_sim_slicing/volume_checks.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

class GlSlicerScan : public testing::TestWithParam<GlProvider> {
 protected:
  static void expectSameVoxels(const Mesh& mesh) {
    const DisplayProfile profile = loadProfile("perspecta");
    const Volume CPUs = sliceExactly(mesh, profile);
    const auto context = openTestContext(GetParam());
    const GlScope scope(*context);
    const GlMesh onGpu(*context, mesh);
    GlVolume volume(*context, profile);
    for (const GlPrecision precision : {GlPrecision::kDouble, GlPrecision::kSingle}) {
      GlSlicer(*context, precision).slice(onGpu, volume);
      const size_t differing = test::differingVoxels(volume.read(), CPUs);
      RecordProperty(precision == GlPrecision::kDouble ? "differingInDouble" : "differingInSingle",
                     static_cast<int>(differing));
      if (precision == GlPrecision::kDouble && context->info().isSoftware) {
        EXPECT_EQ(differing, 0u);
      }
      EXPECT_LE(differing, CPUs.litVoxels() / 10000);
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Providers, GlSlicerScan, kOffscreenProviders, providerName);

TEST_P(GlSlicerScan, bunny) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set: this test needs its bunny.obj";
  }
  expectSameVoxels(loadScene(std::string(folder) + "/bunny.obj"));
}

TEST_P(GlSlicerScan, ocriOfABuiltinScene) {
  const PinholeCamera camera{View{}, kDefaultWidth, kDefaultHeight};
  expectSameVoxels(imageMesh(buildDdocImage(camera, loadScene("builtin:statues"), DdocOptions{})));
}

}  // namespace
}  // namespace ocelli
