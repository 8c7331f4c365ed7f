#include "oc_core/camera/spoc_camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr glm::vec2 kPole{40, 30};

SpocCamera camera(float nearPixels = 0) {
  return {smallCamera(), {kPole, 8, 12, nearPixels, 10}};
}

/// The pinhole's image point of a world point.
ImagePoint pinholeImage(const glm::vec3& point) {
  const PinholeCamera pinhole = smallCamera();
  return pinhole.imageFromCamera(pinhole.cameraFromWorld(point));
}
glm::vec3 worldPoint(const ImagePoint& undistorted) {
  return *smallCamera().unproject(undistorted);
}

// Equation 3.1 by hand: (46, 38) lies along (3, 4) / 5 from the pole, 10 pixels away.
TEST(SpocCamera, projectsByEquation31) {
  const auto expectPushed = [](const SpocCamera& spoc, float z, float pixels) {
    const std::optional<ImagePoint> q = spoc.project(worldPoint({46, 38, z}));
    ASSERT_TRUE(q);
    // World coordinates of 10 units round by 5e-7, 1.5e-4 pixels at these depths.
    EXPECT_NEAR(q->u, 46 + 0.6f * pixels, 1e-3f) << z;
    EXPECT_NEAR(q->v, 38 + 0.8f * pixels, 1e-3f) << z;
    EXPECT_NEAR(q->t, z, 1e-5f * z);
  };
  expectPushed(camera(), 4, 0);
  expectPushed(camera(), 8, 0);
  expectPushed(camera(), 9.6f, 5);  // 1/9.6 is half way between 1/8 and 1/12
  expectPushed(camera(), 12, 10);
  expectPushed(camera(), 500, 10);  // clamped beyond z_f
  expectPushed(camera(4), 7.9f, 0);
  expectPushed(camera(4), 9.6f, 7);
  expectPushed(camera(4), 12, 10);
}

// Equation 3.2: (48.6, 30) is 8.6 pixels from the pole, so it comes from 3.6 at the middle of the ramp.
TEST(SpocCamera, unprojectsByEquation32) {
  const std::optional<glm::vec3> point = camera().unproject({48.6f, 30, 9.6f});
  ASSERT_TRUE(point);
  const ImagePoint undistorted = pinholeImage(*point);
  EXPECT_NEAR(undistorted.u, 43.6f, 1e-3f);
  EXPECT_NEAR(undistorted.v, 30, 1e-3f);
  EXPECT_FALSE(camera().unproject({48.6f, 30, 12})) << "d(z) is longer than the way to the pole";
  EXPECT_FALSE(camera().unproject({40, 30, 9.6f})) << "the pole itself";
  EXPECT_TRUE(camera().unproject({40, 30, 8})) << "not displaced yet";
}

TEST(SpocCamera, nothingProjectsOntoThePole) {
  for (const float z : {8.01f, 9.0f, 10.0f, 12.0f, 300.0f}) {
    const SpocCamera spoc = camera();
    EXPECT_FALSE(spoc.project(worldPoint({kPole.x, kPole.y, z})) &&
                 pinholeImage(worldPoint({kPole.x, kPole.y, z})).u == kPole.x)
        << z;
    for (const glm::vec2 offset : {glm::vec2(0.01f, 0), glm::vec2(0, -3), glm::vec2(7, 7)}) {
      const std::optional<ImagePoint> q = spoc.project(worldPoint({kPole.x + offset.x, kPole.y + offset.y, z}));
      ASSERT_TRUE(q);
      EXPECT_GT(glm::distance(glm::vec2(q->u, q->v), kPole), spoc.displacementAt(q->t)) << z;
    }
  }
  // With the pole on the view axis rounding does not blur it.
  const SpocCamera centred(smallCamera(), {{45, 30}, 8, 12, 0, 10});
  EXPECT_FALSE(centred.project({0, 0, 0}));
  EXPECT_TRUE(centred.project({0, 0, 3})) << "before z_n";
}

// "Effectively piecewise linear rays": to z_n along the pinhole's ray, then straight to the pole or to z_f, and on.
TEST(SpocCamera, raysHaveTwoOrThreeSegmentsAndEndAtThePole) {
  const PinholeCamera pinhole = smallCamera();
  const auto depths = [&](const RayPath& path) {
    std::vector<float> z;
    for (const glm::vec3& point : path) {
      z.push_back(pinhole.cameraFromWorld(point).z);
    }
    return z;
  };
  const RayPath far = camera().rayPath({70, 30});
  ASSERT_EQ(far.size(), 4u);
  EXPECT_NEAR(depths(far)[1], 8, 1e-5f);
  EXPECT_NEAR(depths(far)[2], 12, 1e-5f);
  EXPECT_NEAR(pinholeImage(far[1]).u, 70, 1e-3f);
  EXPECT_NEAR(pinholeImage(far[2]).u, 60, 1e-3f);
  EXPECT_NEAR(pinholeImage(far[3]).u, 60, 1e-3f);

  // 5 pixels from the pole: d(z) is 5 at z = 9.6.
  const RayPath ending = camera().rayPath({45, 30});
  ASSERT_EQ(ending.size(), 3u);
  // It ends 1e-3 pixels before: d(z) changes by 1 pixel in 1/z = 1/240, so z by 9.6^2 / 240 * 1e-3.
  EXPECT_NEAR(depths(ending)[2], 9.6f, 1e-3f);
  EXPECT_NEAR(pinholeImage(ending[2]).u, kPole.x, 5e-3f);

  EXPECT_EQ(camera().rayPath(kPole).size(), 2u) << "straight to z_n";
  EXPECT_EQ(camera(4).rayPath({70, 30}).size(), 5u) << "one more where it steps aside";
  EXPECT_EQ(camera(4).rayPath({43, 30}).size(), 2u) << "nearer to the pole than d_n";
}

// Segments are exact: every point of them projects to the pixel.
TEST(SpocCamera, everyPointOfARayProjectsToItsPixel) {
  const SpocCamera spoc = camera();
  for (const glm::vec2 pixel : {glm::vec2(70.5f, 12.5f), glm::vec2(44.5f, 33.5f), glm::vec2(0.5f, 0.5f)}) {
    const RayPath path = spoc.rayPath(pixel);
    for (size_t i = 1; i < path.size(); ++i) {
      for (const float share : {0.1f, 0.37f, 0.5f, 0.8f}) {
        const std::optional<ImagePoint> q = spoc.project(path[i - 1] + (path[i] - path[i - 1]) * share);
        ASSERT_TRUE(q);
        // Near the eye rounding is 0.015 pixels; around the pole it is magnified, up to 25 times here.
        const float tolerance = q->t < 1 ? 0.02f : 5e-3f;
        EXPECT_NEAR(q->u, pixel.x, tolerance);
        EXPECT_NEAR(q->v, pixel.y, tolerance);
      }
    }
  }
}

TEST(SpocCamera, ofDisplacementsItBoundsEachAndReachesThem) {
  const SpocCamera spoc = camera(3);
  std::mt19937 random(3);
  const auto next = [&](float least, float most) {
    return least + (most - least) * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
  };
  for (int round = 0; round < 300; ++round) {
    const glm::vec2 lower(next(-20, 80), next(-20, 70));
    const glm::vec2 size(next(0, round % 2 ? 40.0f : 4.0f), next(0, round % 3 ? 40.0f : 4.0f));
    const float zLeast = next(6, 14);
    const float zMost = zLeast + next(0, 4);
    const ImageBox bound = spoc.displacementOver({lower, lower + size}, 1 / zMost, 1 / zLeast);
    ImageBox reached{glm::vec2(100), glm::vec2(-100)};
    constexpr int kBoxSteps = 24;
    for (int i = 0; i <= kBoxSteps; ++i) {
      for (int j = 0; j <= kBoxSteps; ++j) {
        for (int k = 0; k <= 8; ++k) {
          const ImagePoint q{lower.x + size.x * static_cast<float>(i) / kBoxSteps,
                             lower.y + size.y * static_cast<float>(j) / kBoxSteps,
                             zLeast + (zMost - zLeast) * static_cast<float>(k) / 8};
          const ImagePoint d = spoc.distort(q);
          reached.lower = glm::min(reached.lower, glm::vec2(d.u - q.u, d.v - q.v));
          reached.upper = glm::max(reached.upper, glm::vec2(d.u - q.u, d.v - q.v));
        }
      }
    }
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_LE(bound.lower[axis], reached.lower[axis] + 1e-4f);
      EXPECT_GE(bound.upper[axis], reached.upper[axis] - 1e-4f);
      // Tight: off by what samples 1/24 of the box apart may miss, where the pole is far, and never by more than d.
      const glm::vec2 away = glm::max(glm::max(lower - kPole, kPole - lower - size), glm::vec2(0));
      const float slack = glm::length(away) > 10 ? 10 * (glm::length(size) / kBoxSteps) / 10 + 0.05f : 10;
      EXPECT_GE(bound.lower[axis], reached.lower[axis] - slack);
      EXPECT_LE(bound.upper[axis], reached.upper[axis] + slack);
    }
  }
}

TEST(SpocCamera, aroundObjectPutsThePoleOnItAndTheFarEndBehindTheScene) {
  const PinholeCamera pinhole = smallCamera();
  const Mesh object = test::wall(0.5f, 0.2f);
  const Mesh scene = test::boxBeforeWall(0.9f);
  SpocOptions options;
  options.farDisplacementPerHeight = 0.2f;
  const SpocCamera spoc = SpocCamera::aroundObject(pinhole, object.positions, scene.positions, options);
  EXPECT_NEAR(spoc.distortion().pole.x, 45, 1e-4f);
  EXPECT_NEAR(spoc.distortion().pole.y, 30, 1e-4f);
  EXPECT_NEAR(spoc.distortion().zNear, 9.5f, 1e-5f);
  EXPECT_NEAR(spoc.distortion().zFar, 10 - test::kWallZ, 1e-5f);
  EXPECT_EQ(spoc.distortion().nearPixels, 0);
  EXPECT_FLOAT_EQ(spoc.distortion().farPixels, 12);
}

// A cone whose tip points away: the pole meets it at its far tip, where masking puts z_n.
TEST(SpocCamera, maskingPutsTheNearEndWhereThePoleMeetsTheObject) {
  const PinholeCamera pinhole = smallCamera();
  std::vector<glm::vec3> cone{{0, 0, 0}};
  for (const glm::vec2 rim : {glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)}) {
    cone.emplace_back(rim * 0.5f, 0.6f);
  }
  std::vector<glm::vec3> scene = cone;
  scene.emplace_back(0, 0, -1);
  SpocOptions options;
  EXPECT_NEAR(SpocCamera::aroundObject(pinhole, cone, scene, options).distortion().zNear, 10, 1e-5f);
  options.maskPole = false;
  EXPECT_NEAR(SpocCamera::aroundObject(pinhole, cone, scene, options).distortion().zNear, 9.4f, 1e-5f);
}

TEST(SpocCamera, badParametersAreRefused) {
  const auto refused = [](const SpocDistortion& distortion) {
    EXPECT_THROW(SpocCamera(smallCamera(), distortion), InputError);
  };
  const SpocDistortion good{{45, 30}, 9, 11, 0, 5};
  EXPECT_NO_THROW(SpocCamera(smallCamera(), good));
  for (const float value : {kNotANumber, kInfinity, -kInfinity}) {
    for (float SpocDistortion::*member :
         {&SpocDistortion::zNear, &SpocDistortion::zFar, &SpocDistortion::nearPixels, &SpocDistortion::farPixels}) {
      SpocDistortion bad = good;
      bad.*member = value;
      refused(bad);
    }
    refused({{value, 30}, 9, 11, 0, 5});
    refused({{45, value}, 9, 11, 0, 5});
  }
  refused({{45, 30}, 9, 9, 0, 5});
  refused({{45, 30}, 9, 8, 0, 5});
  refused({{45, 30}, 0, 8, 0, 5});
  refused({{45, 30}, -1, 8, 0, 5});
  refused({{45, 30}, 1e-42f, 1e-41f, 0, 5});
  refused({{45, 30}, 9, 11, -1, 5});
  refused({{45, 30}, 9, 11, 6, 5});
  refused({{45, 30}, 9, 11, 0, 1e6f});
}

TEST(SpocCamera, objectsOutOfViewAndFlatScenesAreRefused) {
  const PinholeCamera pinhole = smallCamera();
  const std::vector<glm::vec3> none;
  const std::vector<glm::vec3> behind{{0, 0, 12}, {0.1f, 0, 12}};
  const std::vector<glm::vec3> aside{{30, 0, 0}};
  const std::vector<glm::vec3> broken{{kNotANumber, 0, 0}, {0, kInfinity, 0}};
  const std::vector<glm::vec3> flat{{0, 0, 0}, {0.1f, 0, 0}};
  for (const auto& points : {none, behind, aside, broken, flat}) {
    EXPECT_THROW(SpocCamera::aroundObject(pinhole, points, points), InputError);
  }
}

// A pole out of the image is allowed: everything is pushed the same way, more or less.
TEST(SpocCamera, poleMayLieOutOfTheImage) {
  const SpocCamera spoc(smallCamera(), {{-200, 30}, 8, 12, 0, 10});
  for (int y = 0; y < kHeight; y += 7) {
    for (int x = 0; x < kWidth; x += 7) {
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      EXPECT_EQ(spoc.rayPath(pixel).size(), 4u);
      const std::optional<glm::vec3> point = spoc.unproject({pixel.x, pixel.y, 12});
      ASSERT_TRUE(point);
      EXPECT_NEAR(spoc.project(*point)->u, pixel.x, 1e-3f);
    }
  }
}

}  // namespace
}  // namespace ocelli
