#include "display_sim/viewer/frame_comparison_draw.h"

#include <gtest/gtest.h>

#include "oc_core/evaluation/frame_errors.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/gl/gl_test_context.h"

namespace ocelli {
namespace {

class FrameComparisonDrawTest : public testing::TestWithParam<GlProvider> {};
INSTANTIATE_TEST_SUITE_P(Providers, FrameComparisonDrawTest, kOffscreenProviders, providerName);

/// A triangle that faces the eye at (0, 0, 10).
Mesh triangleAt(float z, float side) {
  Mesh mesh;
  mesh.positions = {{-side, -side, z}, {side, -side, z}, {0, side, z}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

MissingSamples compared(GlContext& context, const Mesh& truth, const Mesh& frame, const PinholeCamera& camera) {
  const GlScope scope(context);
  MeshDraw meshes(context);
  FrameComparisonDraw comparison(context);
  Box bounds = boundsOf(truth);
  bounds.add(boundsOf(frame).lower);
  bounds.add(boundsOf(frame).upper);
  return comparison.draw(GlMesh(context, truth), GlMesh(context, frame), bounds, camera, glm::vec3(0), meshes);
}

TEST_P(FrameComparisonDrawTest, theSameMeshMissesNothing) {
  const auto context = openTestContext(GetParam());
  const Mesh mesh = triangleAt(0, 0.5f);
  const MissingSamples missing = compared(*context, mesh, mesh, {View{}, 100, 100});
  EXPECT_GT(missing.truth, 500U);
  EXPECT_EQ(missing.strict, 0U);
  EXPECT_EQ(missing.thick, 0U);
}

TEST_P(FrameComparisonDrawTest, anEmptyFrameMissesAllAndItsInsideThickly) {
  const auto context = openTestContext(GetParam());
  Mesh away = triangleAt(0, 0.5f);
  for (glm::vec3& position : away.positions) {
    position.x += 100;
  }
  const MissingSamples missing = compared(*context, triangleAt(0, 0.5f), away, {View{}, 100, 100});
  EXPECT_EQ(missing.strict, missing.truth);
  EXPECT_LT(missing.thick, missing.strict);
  EXPECT_GT(missing.thick, missing.strict / 2);
}

TEST_P(FrameComparisonDrawTest, nearIsOneAndAHalfFootprints) {
  const auto context = openTestContext(GetParam());
  const PinholeCamera camera(View{}, 100, 100);
  const float footprint = 10 / camera.focalPixels();
  EXPECT_EQ(compared(*context, triangleAt(0, 0.5f), triangleAt(1.4f * footprint, 0.5f), camera).strict, 0U);
  const MissingSamples missing = compared(*context, triangleAt(0, 0.5f), triangleAt(1.6f * footprint, 0.5f), camera);
  EXPECT_EQ(missing.strict, missing.truth);
}

// The definition is that of `ocelli evaluate`; the GPU fills triangles on its own, so samples at edges may differ.
TEST_P(FrameComparisonDrawTest, countsWhatTheEvaluationCounts) {
  const auto context = openTestContext(GetParam());
  for (const char* source : {"builtin:room", "builtin:fence", "builtin:statues"}) {
    const Mesh scene = loadScene(source);
    for (const char* name : {"di", "ddoc"}) {
      const PinholeCamera reference(View{}, 360, 240);
      const Mesh mesh = buildRepresentation(cameraChoice(name), reference, scene).mesh;
      const PinholeCamera camera(movedEye(View{}, {-0.8f, 0.8f, 0}), 360, 240);
      const MissingSamples expected =
          countMissing(compareFrames(camera, positionImage(camera, scene), positionImage(camera, mesh)));
      const MissingSamples got = compared(*context, scene, mesh, camera);
      // Measured: 4e-5 at most. 1e-4 is one unit of the last decimal that the window shows.
      EXPECT_NEAR(got.strictRatio(), expected.strictRatio(), 1e-4) << source << ' ' << name;
      EXPECT_NEAR(got.thickRatio(), expected.thickRatio(), 1e-4) << source << ' ' << name;
      EXPECT_NEAR(static_cast<double>(got.truth), static_cast<double>(expected.truth),
                  1e-3 * static_cast<double>(expected.truth));
    }
  }
}

TEST_P(FrameComparisonDrawTest, theTruthLooksAsTheCpuDrawsIt) {
  const auto context = openTestContext(GetParam());
  const Mesh scene = loadScene("builtin:statues");
  const PinholeCamera camera(movedEye(View{}, {0.5f, 0.3f, 0}), 180, 120);
  const Image<Rgb8> expected = renderFrame(camera, scene).image;
  const GlScope scope(*context);
  MeshDraw meshes(*context);
  FrameComparisonDraw comparison(*context);
  const GlMesh mesh(*context, scene);
  comparison.draw(mesh, mesh, boundsOf(scene), camera, glm::vec3(0), meshes);
  const Image<Rgb8> got = comparison.truth().read();
  size_t different = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    const glm::ivec3 step = glm::abs(glm::ivec3(got[i]) - glm::ivec3(expected[i]));
    different += std::max({step.x, step.y, step.z}) > 1;  // rounding of sRGB
  }
  // The rest are samples at edges, which the two snap to their grids differently.
  EXPECT_LT(static_cast<double>(different), 0.005 * static_cast<double>(got.size()));
}

}  // namespace
}  // namespace ocelli
