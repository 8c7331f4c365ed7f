#include "oc_core/camera/ddoc_camera.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

/// Every pixel displaced by the same (6, -2) pixels between z_n = 8 and z_f = 12.
DdocCamera evenCamera(DistortionMap::Lookup lookup) {
  DistortionMap map(kWidth, kHeight, lookup);
  for (DistortionSample& sample : map.samples()) {
    sample = {{6, -2}, 1 / 8.0f, 1 / 12.0f};
  }
  return {smallCamera(), map};
}

// Equation 3.3 by hand: on the view axis, whose pinhole image is the middle (45, 30). World z = 10 - depth.
TEST(DdocCamera, projectsByEquation33) {
  for (const auto lookup : {DistortionMap::Lookup::kNearest, DistortionMap::Lookup::kBilinear}) {
    const DdocCamera camera = evenCamera(lookup);
    const auto expectShare = [&](float depth, float share) {
      const std::optional<ImagePoint> q = camera.project({0, 0, 10 - depth});
      ASSERT_TRUE(q);
      EXPECT_NEAR(q->u, 45 + 6 * share, 1e-4f) << depth;
      EXPECT_NEAR(q->v, 30 - 2 * share, 1e-4f) << depth;
      EXPECT_NEAR(q->t, depth, 1e-5f);
    };
    expectShare(4, 0);
    expectShare(8, 0);
    expectShare(9.6f, 0.5f);  // 1/9.6 is half way between 1/8 and 1/12
    expectShare(12, 1);
    expectShare(800, 1);
  }
}

TEST(DdocCamera, looksTheDistortionUpAtTheUndistortedPixel) {
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kNearest);
  map.samples()(50, 30) = {{10, 0}, 1 / 8.0f, 1 / 12.0f};
  const DdocCamera camera(smallCamera(), map);
  EXPECT_EQ(camera.distort({50.5f, 30.5f, 12}).u, 60.5f);
  EXPECT_EQ(camera.distort({60.5f, 30.5f, 12}).u, 60.5f) << "where another sample lands, nothing is displaced";
  EXPECT_FLOAT_EQ(camera.longestDisplacement(), 10);
}

// Two displaced samples, at (20, 10) and (70, 40). A lookup mixes the four samples around a point, so each is felt
// between the centres of its neighbours, a pixel away.
TEST(DdocCamera, saysWhereItMayDisplace) {
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kBilinear);
  map.samples()(20, 10) = {{1, 0}, 1 / 8.0f, 1 / 12.0f};
  map.samples()(70, 40) = {{0, 1}, 1 / 8.0f, 1 / 12.0f};
  const DdocCamera camera(smallCamera(), map);
  const auto displaces = [&](float left, float top, float right, float bottom) {
    return camera.displacesWithin({{left, top}, {right, bottom}});
  };
  EXPECT_TRUE(displaces(0, 0, kWidth, kHeight));
  EXPECT_TRUE(displaces(20.5f, 10.5f, 20.5f, 10.5f));
  EXPECT_TRUE(displaces(21.4f, 11.4f, 30, 12));
  EXPECT_TRUE(displaces(0, 0, 19.6f, 9.6f));
  EXPECT_FALSE(displaces(0, 0, 18.4f, kHeight));
  EXPECT_FALSE(displaces(22.6f, 0, 68.4f, kHeight));
  EXPECT_FALSE(displaces(0, 12.6f, 68.4f, kHeight));
  EXPECT_FALSE(displaces(-500, -500, -1, -1)) << "there it is what it is at the corner";

  // Wherever a point is displaced, no box around it may deny it.
  std::mt19937 random(3);
  const auto next = [&](float most) { return most * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24); };
  int displaced = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec2 point(18 + next(6), 8 + next(6));
    const ImagePoint moved = camera.distort({point.x, point.y, 1e6f});
    if (moved.u != point.x || moved.v != point.y) {
      ++displaced;
      const glm::vec2 margin(next(3), next(3));
      EXPECT_TRUE(camera.displacesWithin({point, point}));
      EXPECT_TRUE(camera.displacesWithin({point - margin, point + margin}));
    }
  }
  EXPECT_GT(displaced, 2000) << "2 x 2 of 6 x 6 pixels";
}

// "They remain unaffected until they reach z_n ... the rays continue with a constant amount of distortion d_f" (3.2.1).
// Points of a path here lie on three straight lines of the image: undistorted (u, v) as a function of 1/z.
TEST(DdocCamera, rayIsStraightThenBentThenStraight) {
  const DdocCamera camera = evenCamera(DistortionMap::Lookup::kBilinear);
  const PinholeCamera reference = smallCamera();
  for (const glm::vec3& point : camera.rayPath({40.5f, 20.5f})) {
    const ImagePoint q = reference.imageFromCamera(reference.cameraFromWorld(point));
    const float share = std::clamp((1 / 8.0f - 1 / q.t) / (1 / 8.0f - 1 / 12.0f), 0.0f, 1.0f);
    // Next to the eye (z = 0.01) a world coordinate of 10 rounds by 5e-7, which is 0.015 pixels.
    const float tolerance = q.t < 1 ? 0.05f : 2e-3f;
    EXPECT_NEAR(q.u, 40.5f - 6 * share, tolerance) << q.t;
    EXPECT_NEAR(q.v, 20.5f + 2 * share, tolerance) << q.t;
  }
}

/// Pixels left of the middle are pushed by `left`, the others by `right` pixels along u.
DdocCamera splitCamera(float left, float right) {
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kNearest);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      map.samples()(x, y) = {{x < kWidth / 2 ? left : right, 0}, 1 / 8.0f, 1 / 12.0f};
    }
  }
  return {smallCamera(), map};
}

void expectRayProjectsTo(const DdocCamera& camera, const glm::vec2& pixel) {
  for (const glm::vec3& point : camera.rayPath(pixel)) {
    if (const auto q = camera.project(point)) {
      EXPECT_NEAR(q->u, pixel.x, q->t < 1 ? 0.05f : 2e-3f) << q->t;
    }
  }
}

// The halves are pushed over each other: pixels between 25 and 65 have two solutions, of which one is returned.
TEST(DdocCamera, foldedFieldGivesOneOfTheSolutions) {
  const DdocCamera camera = splitCamera(20, -20);
  for (int x = 0; x < kWidth; ++x) {
    const glm::vec2 pixel(static_cast<float>(x) + 0.5f, 30.5f);
    const auto point = camera.unproject({pixel.x, pixel.y, 12.5f});
    ASSERT_TRUE(point) << x;
    EXPECT_NEAR(camera.project(*point)->u, pixel.x, 2e-3f);
    expectRayProjectsTo(camera, pixel);
  }
}

// The halves are pushed apart: beyond z_f nothing has an image between 25 and 65, and rays end on their way there.
TEST(DdocCamera, tornFieldGivesNoSolutionInTheTear) {
  const DdocCamera camera = splitCamera(-20, 20);
  for (int x = 0; x < kWidth; ++x) {
    const glm::vec2 pixel(static_cast<float>(x) + 0.5f, 30.5f);
    EXPECT_TRUE(camera.unproject({pixel.x, pixel.y, 7.9f})) << "before z_n";
    EXPECT_EQ(camera.unproject({pixel.x, pixel.y, 12.5f}).has_value(), x < 25 || x >= 65) << x;
    expectRayProjectsTo(camera, pixel);
  }
}

TEST(DdocCameraDeathTest, mapMustHaveTheSizeOfTheCamera) {
  EXPECT_DEATH(DdocCamera(smallCamera(), DistortionMap(3, 3, DistortionMap::Lookup::kNearest)), "distortion map");
}

}  // namespace
}  // namespace ocelli
