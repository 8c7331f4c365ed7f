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

/// The slow reference: the undistorted point by a damped fixed-point search, until it is displaced to within 1e-5
/// pixels of the target.
glm::dvec2 searched(const DdocCamera& camera, const ImagePoint& target) {
  glm::dvec2 x(target.u, target.v);
  for (int step = 0; step < 2000; ++step) {
    const ImagePoint image = camera.distort({static_cast<float>(x.x), static_cast<float>(x.y), target.t});
    const glm::dvec2 residual(target.u - image.u, target.v - image.v);
    if (glm::length(residual) < 1e-5) {
      break;
    }
    x += residual * 0.5;
  }
  return x;
}

// The field's slope is 3 (2 pi / 40) = 0.47 at most, so an error of the displaced point, 6e-5 pixels, is less than
// twice as large in the undistorted one, which rounds by some 5e-5 when it is unprojected and projected again. Where a
// border between cells turns the steps back and forth, the camera searches too, to 1e-3 pixels.
TEST(DdocCamera, invertsAsTheSearchDoes) {
  const DdocCamera camera(smallCamera(), test::wavyMap(kWidth, kHeight, 3, 40));
  const PinholeCamera reference = smallCamera();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> u(8, kWidth - 8);
  std::uniform_real_distribution<float> v(8, kHeight - 8);
  std::uniform_real_distribution<float> z(7, 16);
  int searches = 0;
  for (int i = 0; i < 5000; ++i) {
    const ImagePoint q{u(random), v(random), z(random)};
    const std::optional<glm::vec3> point = camera.unproject(q);
    ASSERT_TRUE(point);
    const ImagePoint got = reference.imageFromCamera(reference.cameraFromWorld(*point));
    const glm::dvec2 expected = searched(camera, q);
    const double error = glm::distance(glm::dvec2(got.u, got.v), expected);
    EXPECT_LT(error, 2e-3) << i;
    searches += error > 3e-4;
  }
  EXPECT_LT(searches, 50);
}

// Between its points a path is straight: it may be off there by the chord of a bend, of which each step may take 0.04
// pixels, twice as much where the field's slope is felt.
TEST(DdocCamera, pathsKeepToTheirPixelsBetweenTheirPoints) {
  const DdocCamera camera(smallCamera(), test::wavyMap(kWidth, kHeight, 3, 40));
  size_t points = 0;
  size_t paths = 0;
  for (int y = 10; y < kHeight - 10; y += 3) {
    for (int x = 10; x < kWidth - 10; x += 3) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const RayPath path = camera.rayPath(pixel);
      points += path.size();
      ++paths;
      for (float depth = 6; depth < 18; depth += 0.037f) {
        const std::optional<ImagePoint> q = camera.project(path.pointAt(path.positionAt(depth)));
        ASSERT_TRUE(q);
        EXPECT_NEAR(q->u, pixel.x, 0.08f) << depth;
        EXPECT_NEAR(q->v, pixel.y, 0.08f) << depth;
      }
    }
  }
  // The longest displacement of 4.3 pixels takes 17 steps, were each taken by itself.
  EXPECT_LT(points, 15 * paths);
}

}  // namespace
}  // namespace ocelli
