#include "oc_core/ocri/ddoc_builder.h"

#include <gtest/gtest.h>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/image_mesh.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kBoxFrontZ;
using test::kBoxHalf;
using test::kHeight;
using test::kWallZ;
using test::kWidth;
using test::smallCamera;

/// Half the width of the box's front in the image, pixels: 9.6.
float boxHalfPixels() {
  return smallCamera().focalPixels() * kBoxHalf / (10 - kBoxFrontZ);
}

/// Samples of the wall that the reference pinhole cannot see behind the box, on each side of it.
struct HiddenSamples {
  int left = 0;
  int right = 0;
  int top = 0;
  int bottom = 0;
};

HiddenSamples hiddenWallSamples(const ReferenceImage& image) {
  HiddenSamples hidden;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const ImagePoint q = image.undistorted(x, y);
      const glm::vec2 fromMiddle(q.u - kWidth / 2.0f, q.v - kHeight / 2.0f);
      const glm::vec2 inside = boxHalfPixels() - glm::abs(fromMiddle);
      if (image.t(x, y) > 10.8f && inside.x > 0.02f && inside.y > 0.02f) {
        hidden.left += inside.x < inside.y && fromMiddle.x < 0;
        hidden.right += inside.x < inside.y && fromMiddle.x > 0;
        hidden.top += inside.x >= inside.y && fromMiddle.y < 0;
        hidden.bottom += inside.x >= inside.y && fromMiddle.y > 0;
      }
    }
  }
  return hidden;
}

float distanceToBoxOrWall(const glm::vec3& p) {
  const glm::vec3 out = glm::abs(p - glm::vec3(0, 0, kBoxFrontZ - kBoxHalf)) - kBoxHalf;
  const float box = glm::length(glm::max(out, 0.0f)) + std::min(std::max({out.x, out.y, out.z}), 0.0f);
  return std::min(std::abs(box), std::abs(p.z - kWallZ));
}

double strictMissing(const Mesh& truth, const ReferenceImage& image, const PinholeCamera& camera) {
  return countMissing(compareFrames(camera, positionImage(camera, truth), positionImage(camera, imageMesh(image))))
      .strictRatio();
}

// The view cell uncovers f * 0.8 * (1/9.3 - 1/10.9) = 3.8 pixels behind each side of the box, 19 pixels long; squeezed
// by half they are about 1.9 columns of samples. One along most of each side is the least to expect.
TEST(DdocBuilder, hiddenWallSamplesAppearOnEverySide) {
  const Mesh mesh = test::boxBeforeWall();
  const ReferenceImage depth = buildDepthImage(smallCamera(), mesh);
  const HiddenSamples none = hiddenWallSamples(depth);
  EXPECT_EQ(none.left + none.right + none.top + none.bottom, 0);
  for (const DdocOptions& options : {DdocOptions{}, DdocOptions::paper(6)}) {
    const HiddenSamples hidden = hiddenWallSamples(buildDdocImage(buildDdocCamera(smallCamera(), mesh, options), mesh));
    EXPECT_GE(hidden.left, 14);
    EXPECT_GE(hidden.right, 14);
    EXPECT_GE(hidden.top, 14);
    EXPECT_GE(hidden.bottom, 14);
  }
}

TEST(DdocBuilder, everySampleUnprojectsOntoTheSurface) {
  const Mesh mesh = test::boxBeforeWall();
  const PinholeCamera camera = smallCamera();
  for (const DdocOptions& options : {DdocOptions{}, DdocOptions::paper(6)}) {
    const ReferenceImage image = buildDdocImage(buildDdocCamera(camera, mesh, options), mesh);
    EXPECT_GT(image.sampleCount(), static_cast<size_t>(kWidth * kHeight) * 9 / 10);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (image.holds(x, y)) {
          const std::optional<glm::vec3> point = camera.unproject(image.undistorted(x, y));
          ASSERT_TRUE(point);
          // Single precision: coordinates of 10 units, image coordinates of 90 pixels of 0.03 units.
          EXPECT_LT(distanceToBoxOrWall(*point), 1e-5f) << x << " " << y;
        }
      }
    }
  }
}

// The text's construction by hand, to the right of the box and away from its corners: the silhouette runs between the
// pixels on both sides of column 55, so sample x lies s = x + 0.5 - 55 from it; |s| <= D is displaced by (D - s) / 2.
TEST(DdocBuilder, constantRadiusIsTheTexts) {
  constexpr float kRadius = 6;
  const float silhouette = std::round(kWidth / 2.0f + boxHalfPixels());
  ASSERT_EQ(silhouette, 55);
  const DdocCamera camera = buildDdocCamera(smallCamera(), test::boxBeforeWall(), DdocOptions::paper(kRadius));
  EXPECT_EQ(camera.map().lookup(), DistortionMap::Lookup::kNearest);
  for (int y = 28; y < 32; ++y) {
    for (int x = 46; x < kWidth; ++x) {
      const float s = static_cast<float>(x) + 0.5f - silhouette;
      const DistortionSample& sample = camera.map().samples()(x, y);
      const bool splatted = std::abs(s) <= kRadius;
      EXPECT_NEAR(sample.displacement.x, splatted ? (kRadius - s) / 2 : 0, 1e-4f) << x;
      EXPECT_NEAR(sample.displacement.y, 0, 1e-4f) << x;
      if (splatted) {
        EXPECT_NEAR(sample.inverseNear, 1 / 9.3f, 1e-6f);
        EXPECT_NEAR(sample.inverseFar, 1 / 10.9f, 1e-6f);
      }
    }
  }
}

TEST(DdocBuilder, errorFallsWhereTheEyeMovesWithoutHarmAtTheReference) {
  const Mesh mesh = test::boxBeforeWall(0.9f);
  const ReferenceImage depth = buildDepthImage(smallCamera(), mesh);
  const ReferenceImage ddoc = buildDdocImage(buildDdocCamera(smallCamera(), mesh), mesh);
  for (const glm::vec3 offset : {glm::vec3(0.8f, 0, 0), glm::vec3(0, -0.8f, 0), glm::vec3(-0.8f, 0.8f, 0)}) {
    const PinholeCamera moved(movedEye(View{}, offset), kWidth, kHeight);
    const double before = strictMissing(mesh, depth, moved);
    EXPECT_GT(before, 0.005) << "a shadow of nearly 4 x 19 pixels";
    EXPECT_LT(strictMissing(mesh, ddoc, moved), before / 2);
  }
  // At most half a percent of the samples: the figure that the full size must keep.
  EXPECT_LE(strictMissing(mesh, ddoc, smallCamera()), 0.005);
}

TEST(DdocBuilder, feedbackDoesNoMoreHarmThanNone) {
  for (const Mesh& mesh : {test::boxBeforeWall(), test::ballBeforePlane()}) {
    const auto harm = [&](int rounds) {
      DdocOptions options;
      options.feedbackRounds = rounds;
      return strictMissing(mesh, buildDdocImage(buildDdocCamera(smallCamera(), mesh, options), mesh), smallCamera());
    };
    EXPECT_LE(harm(DdocOptions{}.feedbackRounds), harm(0));
  }
}

TEST(DdocBuilder, sceneWithoutDepthEdgesIsLeftAlone) {
  const DdocCamera camera = buildDdocCamera(smallCamera(), test::tiltedPlane(3, 30));
  EXPECT_EQ(camera.longestDisplacement(), 0);
}

TEST(DdocBuilder, boundIsTheDepthImagesMeshAndIsKept) {
  Mesh twoBalls = makeSphere(32);
  paint(twoBalls, glm::vec3(0.5f));
  for (glm::vec3& p : twoBalls.positions) {
    p = p * 0.4f + glm::vec3(0.1f, 0, 0.5f);
  }
  append(twoBalls, twoBalls, glm::translate(glm::mat4(1), glm::vec3(-0.3f, 0.1f, -1)));
  for (const Mesh& mesh : {test::boxBeforeWall(), test::ballBeforePlane(), twoBalls}) {
    const ReferenceImage image = buildDdocImage(buildDdocCamera(smallCamera(), mesh), mesh);
    EXPECT_EQ(image.triangleBound, imageMesh(buildDepthImage(smallCamera(), mesh)).triangles.size());
    EXPECT_LE(imageMesh(image).triangles.size(), image.triangleBound);
  }
}

TEST(DdocBuilder, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::ballBeforePlane();
  const auto build = [&](int threads) {
    setThreadCount(threads);
    const DdocCamera camera = buildDdocCamera(smallCamera(), mesh);
    const ReferenceImage image = buildDdocImage(camera, mesh);
    setThreadCount(0);
    return std::tuple(camera, image, imageMesh(image));
  };
  const auto [camera, image, ocriMesh] = build(1);
  for (const int threads : {2, 8}) {
    const auto [otherCamera, otherImage, otherMesh] = build(threads);
    EXPECT_TRUE(test::sameBytes(otherCamera.map().samples(), camera.map().samples())) << threads;
    EXPECT_TRUE(test::sameBytes(otherImage.color, image.color));
    EXPECT_TRUE(test::sameBytes(otherImage.t, image.t));
    EXPECT_TRUE(test::sameBytes(otherImage.displacement, image.displacement));
    EXPECT_TRUE(test::sameBytes(otherMesh.positions, ocriMesh.positions));
    EXPECT_TRUE(test::sameBytes(otherMesh.colors, ocriMesh.colors));
    EXPECT_TRUE(test::sameBytes(otherMesh.triangles, ocriMesh.triangles));
  }
}

TEST(DdocBuilder, progressRunsToItsEnd) {
  double last = -1;
  buildDdocCamera(smallCamera(), test::boxBeforeWall(), {}, [&](std::string_view, double fraction) {
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    last = fraction;
  });
  EXPECT_EQ(last, 1);
}

// A false skin would span the space between box and wall, 1.2 units or 40 pixel footprints wide.
TEST(DdocBuilder, meshHasNoSkinsAcrossDiscontinuities) {
  const Mesh scene = test::boxBeforeWall();
  const PinholeCamera camera = smallCamera();
  const Mesh mesh = imageMesh(buildDdocImage(buildDdocCamera(camera, scene), scene));
  ASSERT_GT(mesh.triangles.size(), 1000u);
  const float threeFootprints = 3 * (10 - kWallZ) / camera.focalPixels();
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 centroid = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
    EXPECT_LT(distanceToBoxOrWall(centroid), threeFootprints);
  }
}

// Step 5 deletes what step 4 took from a splat: pixels of it are displaced by no other.
TEST(DdocBuilder, literalVariantDeletesWhatConflictsShrank) {
  const Mesh mesh = test::boxBeforeWall();
  DdocOptions reclaiming = DdocOptions::literal();
  reclaiming.reclaimPixels = true;
  const auto displaced = [&](const DdocOptions& options) {
    const DdocCamera camera = buildDdocCamera(smallCamera(), mesh, options);
    const auto& samples = camera.map().samples();
    return std::count_if(samples.begin(), samples.end(),
                         [](const DistortionSample& sample) { return sample.displacement != glm::vec2(0); });
  };
  // Splats of 15 pixels around a box of 19 meet in its middle.
  EXPECT_GT(displaced(DdocOptions::literal()), 0);
  EXPECT_LT(displaced(DdocOptions::literal()), displaced(reclaiming));
}

}  // namespace
}  // namespace ocelli
