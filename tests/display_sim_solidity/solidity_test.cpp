#include "display_sim/solidity/solidity.h"

#include <gtest/gtest.h>

#include "display_sim/slicing/exact_slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/display_sim_slicing/test_meshes.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using Shown = SolidityMeter::Shown;

constexpr float kDepth = 0.3f;  // of the squares, before and behind the middle
constexpr double kShareRounding = 1e-6;

Mesh square(float z) {
  Mesh mesh;
  test::addTriangle(mesh, {-0.5f, -0.5f, z}, {0.5f, -0.5f, z}, {0.5f, 0.5f, z});
  test::addTriangle(mesh, {-0.5f, -0.5f, z}, {0.5f, 0.5f, z}, {-0.5f, 0.5f, z});
  return mesh;
}

/// Two squares of half side 0.5, one behind the other.
class TwoSquares : public testing::Test {
 protected:
  TwoSquares() {
    append(both, square(-kDepth));
    options.groups = {{"front", {{0, 0, 10}}}, {"behind", {{0, 0, -10}}}};
  }

  SolidityFigures measure(const Mesh& mesh, Shown shown = Shown::kEverything) {
    return SolidityMeter(both, options)
        .measure("squares", sliceExactly(mesh, options.profile), mesh.triangles.size(), shown);
  }

  Mesh both = square(kDepth);
  SolidityOptions options{.profile = test::smallProfile(60, 96, 96), .groups = {}};
};

// The display turns one square into the other, so they have as many voxels. A voxel's light is (10 / z)^2 at its
// distance z, and cells reach at most half an arc, 0.016, to both sides of the squares: 0.4 % of light to either side,
// and so 0.2 % of a share of a half.
TEST_F(TwoSquares, halfOfTheLightIsOfTheHiddenOne) {
  const SolidityFigures figures = measure(both);
  ASSERT_EQ(figures.groups.size(), 2u);
  const double nearLight = 1 / std::pow(10 - kDepth, 2);
  const double farLight = 1 / std::pow(10 + kDepth, 2);
  for (const SolidityErrors& errors : figures.groups) {
    EXPECT_EQ(errors.eyes, 1u);
    EXPECT_NEAR(errors.hiddenShare(), farLight / (nearLight + farLight), 0.002);
  }
  EXPECT_EQ(figures.triangles, 4u);
  EXPECT_EQ(figures.litVoxels, sliceExactly(both, options.profile).litVoxels());
}

// A depth image taken from the front has the square in front alone. From behind the other one should hide it.
TEST_F(TwoSquares, whatTheFrontSeesIsAllVisibleFromThereAndHiddenFromBehind) {
  const SolidityFigures figures = measure(square(kDepth));
  EXPECT_EQ(figures.groups[0].hiddenShare(), 0);
  EXPECT_NEAR(figures.groups[1].hiddenShare(), 1, kShareRounding);
}

// Light is taken off in floats, after which a byte may be rounded otherwise: by 1/255, in few of 27648 values.
TEST_F(TwoSquares, visibleVoxelsAreWhatTheFrontSees) {
  const SolidityErrors visible = measure(both, Shown::kVisibleOnly).groups[0];
  const SolidityErrors alone = measure(square(kDepth)).groups[0];
  EXPECT_EQ(visible.hiddenShare(), 0);
  EXPECT_NEAR(visible.psnrDecibels(), alone.psnrDecibels(), 0.01);
  EXPECT_NEAR(visible.meanSsim(), alone.meanSsim(), 0.001);
  EXPECT_NEAR(visible.meanFlip(), alone.meanFlip(), 0.001);
}

TEST_F(TwoSquares, imagesAreThoseThatWereMeasured) {
  size_t visits = 0;
  SolidityMeter(both, options)
      .measure("both", sliceExactly(both, options.profile), 4, Shown::kEverything, {}, [&](const ObservedFrame& frame) {
        EXPECT_EQ(frame.group, visits++);
        EXPECT_EQ(frame.eye, 0u);
        ASSERT_EQ(frame.opaque.width(), options.profile.height);
        const int middle = frame.opaque.width() / 2;
        EXPECT_EQ(frame.opaque(middle, middle), Rgb8(255));
        EXPECT_GT(frame.observed(middle, middle).x, 0);
        EXPECT_GT(frame.hidden(middle, middle).x, 0);
        EXPECT_LE(frame.hidden(middle, middle).x, frame.observed(middle, middle).x);
        EXPECT_EQ(frame.observed(1, 1), Rgb8(0));
      });
  EXPECT_EQ(visits, 2u);
}

TEST_F(TwoSquares, eyesInTheDisplayAreRefused) {
  options.groups[1].eyes = {{0, 0.5f, 0}};
  EXPECT_THROW(SolidityMeter(both, options), InputError);
}

TEST_F(TwoSquares, figuresAreTheSameWithAnyNumberOfThreads) {
  setThreadCount(1);
  const SolidityFigures one = measure(both);
  setThreadCount(3);
  const SolidityFigures three = measure(both);
  setThreadCount(0);
  EXPECT_EQ(one.gain, three.gain);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.groups[i].hiddenLight, three.groups[i].hiddenLight);
    EXPECT_EQ(one.groups[i].squaredError, three.groups[i].squaredError);
    EXPECT_EQ(one.groups[i].ssim, three.groups[i].ssim);
    EXPECT_EQ(one.groups[i].flip, three.groups[i].flip);
  }
}

// What the whole is for: a depth image shows nothing that the reference eye should not see but for voxels at rims, an
// occlusion camera what an eye beside it is about to see, and the full geometry everything.
TEST(Solidity, referenceImagesHideWhatTheGeometryShows) {
  const Mesh scene = loadScene("builtin:room", {});
  const View view;
  const SolidityOptions options{.profile = test::smallProfile(60, 160, 160), .groups = {{"reference", {view.eye}}}};
  SolidityMeter meter(scene, options);
  const auto share = [&](const char* camera) {
    const Mesh mesh = buildRepresentation(cameraChoice(camera), {view, 360, 240}, scene).mesh;
    return meter.measure(camera, sliceExactly(mesh, options.profile), mesh.triangles.size()).groups[0].hiddenShare();
  };
  const double depthImage = share("di");
  const double occlusionCamera = share("ddoc");
  const double geometry = share("geometry");
  EXPECT_LT(depthImage, 0.1 * geometry);
  EXPECT_LT(depthImage, occlusionCamera);
  EXPECT_LT(occlusionCamera, 0.5 * geometry);
}

}  // namespace
}  // namespace ocelli
