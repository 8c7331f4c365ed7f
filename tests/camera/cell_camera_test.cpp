#include "oc_core/camera/cell_camera.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/camera/test_cell_cameras.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr float kPixels =
    2e-3f;  ///< world coordinates of 10 units round by 1e-6, which a focal length of 300 makes this

glm::vec2 centre(int x, int y) {
  return {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
}

TEST(CellCamera, withoutSatellitesItIsThePinhole) {
  const CellCamera alone({{smallCamera(), Image<float>(kWidth, kHeight, smallCamera().view().zFar)}});
  EXPECT_EQ(alone.width(), kWidth);
  EXPECT_EQ(alone.height(), kHeight);
  for (const glm::vec3& point : {glm::vec3(0.1f, 0.2f, 0), glm::vec3(-0.7f, 0.4f, -3), glm::vec3(0, 0, 8)}) {
    const std::optional<ImagePoint> q = alone.project(point);
    const std::optional<ImagePoint> expected = smallCamera().project(point);
    ASSERT_TRUE(q && expected);
    EXPECT_EQ(q->u, expected->u);
    EXPECT_EQ(q->v, expected->v);
    EXPECT_EQ(q->t, expected->t);
    EXPECT_EQ(alone.unproject(*q), smallCamera().unproject(*q));
  }
  EXPECT_EQ(alone.rayPath({12.5f, 40.5f}), smallCamera().rayPath({12.5f, 40.5f}));
}

TEST(CellCamera, tilesOfTheSatelliteStandBelowTheReference) {
  // Columns 50 to 57 and rows 22 to 37 of the satellite: one tile across (45 to 59), two down (15 to 29, 30 to 44).
  ASSERT_EQ(test::twoViewpoints().tiles().size(), 2u);
  EXPECT_EQ(test::twoViewpoints().tiles()[0].corner, glm::ivec2(45, 15));
  EXPECT_EQ(test::twoViewpoints().tiles()[1].corner, glm::ivec2(45, 30));
  EXPECT_EQ(test::twoViewpoints().cornerOf(0), glm::ivec2(0, kHeight));
  EXPECT_EQ(test::twoViewpoints().cornerOf(1), glm::ivec2(CellCamera::kTileSide, kHeight));
  EXPECT_EQ(test::twoViewpoints().width(), kWidth);
  EXPECT_EQ(test::twoViewpoints().height(), kHeight + CellCamera::kTileSide);
}

TEST(CellCamera, pointsBehindTheOccluderHaveTheirImageInTheTiles) {
  const CellCamera::Viewpoint& satellite = test::twoViewpoints().viewpoints()[1];
  size_t hidden = 0;
  for (int y = 22; y < 38; ++y) {
    for (int x = 50; x < 58; ++x) {
      const glm::vec2 pixel = centre(x, y);
      const glm::vec3 point = *satellite.camera.unproject({pixel.x, pixel.y, satellite.reach(x, y)});
      const ImagePoint seen = *smallCamera().project(point);
      const std::optional<ImagePoint> q = test::twoViewpoints().project(point);
      ASSERT_TRUE(q);
      EXPECT_NEAR(q->t, test::kCellWall, 1e-4f);
      if (seen.u > 30 && seen.u < 60 && seen.v > 20 && seen.v < 40) {
        const size_t tile = y < 30 ? 0 : 1;
        const glm::vec2 expected = pixel - glm::vec2(test::twoViewpoints().tiles()[tile].corner) +
                                   glm::vec2(test::twoViewpoints().cornerOf(tile));
        EXPECT_NEAR(q->u, expected.x, kPixels);
        EXPECT_NEAR(q->v, expected.y, kPixels);
        ++hidden;
      } else {
        EXPECT_NEAR(q->u, seen.u, kPixels);
        EXPECT_NEAR(q->v, seen.v, kPixels);
      }
    }
  }
  EXPECT_GT(hidden, 50u);
}

TEST(CellCamera, hiddenPointsThatNoSatelliteReachesHaveNone) {
  EXPECT_FALSE(test::twoViewpoints().project({-0.2f, 0, -0.5f}))
      << "behind the occluder, left of what the satellite stores";
  EXPECT_FALSE(test::twoViewpoints().project({2.0f, 0, -1.5f})) << "behind the wall";
  EXPECT_TRUE(test::twoViewpoints().project({-0.2f, 0, 0.9f})) << "in front of the occluder";
}

TEST(CellCamera, projectOfUnprojectIsTheImagePoint) {
  size_t solved = 0;
  size_t below = 0;
  for (int y = 0; y < test::twoViewpoints().height(); ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const float z : {5.0f, 9.29f, 9.5f, 10.2f, 10.8f}) {
        const std::optional<glm::vec3> point = test::twoViewpoints().unproject({centre(x, y).x, centre(x, y).y, z});
        if (!point) {
          continue;
        }
        const std::optional<ImagePoint> back = test::twoViewpoints().project(*point);
        ASSERT_TRUE(back) << x << " " << y << " " << z;
        ++solved;
        below += y >= kHeight;
        // A tile repeats the first row of the next one; the point projects to the original.
        if (test::isRepeated(centre(x, y))) {
          continue;
        }
        EXPECT_NEAR(back->u, centre(x, y).x, kPixels);
        EXPECT_NEAR(back->v, centre(x, y).y, kPixels);
        EXPECT_NEAR(back->t, z, 1e-5f);
      }
    }
  }
  EXPECT_GT(solved, static_cast<size_t>(kWidth * kHeight * 2));
  EXPECT_GT(below, 100u);
}

TEST(CellCamera, rayPathsProjectToTheirPixels) {
  size_t tiles = 0;
  for (int y = 0; y < test::twoViewpoints().height(); ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const RayPath path = test::twoViewpoints().rayPath(centre(x, y));
      if (y < kHeight) {
        ASSERT_EQ(path.size(), 2u) << "every pixel of the reference has its ray";
      }
      if (path.empty()) {
        continue;
      }
      tiles += y >= kHeight;
      const bool copy =
          y >= kHeight && (x % CellCamera::kTileSide == 15 || (y - kHeight) % CellCamera::kTileSide == 15);
      for (int step = 0; step <= 8 && !copy; ++step) {
        const float t = static_cast<float>(step) / 8;
        const std::optional<ImagePoint> q = test::twoViewpoints().project(path[0] + (path[1] - path[0]) * t);
        if (!q && step == 0) {
          continue;  // rounding may put the near end a hair before zNear
        }
        ASSERT_TRUE(q) << x << " " << y << " " << step;
        const float slack = kPixels + 1e-3f / q->t;
        EXPECT_NEAR(q->u, centre(x, y).x, slack) << y << " " << step;
        EXPECT_NEAR(q->v, centre(x, y).y, slack) << x << " " << step;
      }
    }
  }
  EXPECT_GT(tiles, 50u);
}

TEST(CellCamera, whatIsNoPixelOrNumberHasNone) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const glm::vec2& pixel : {glm::vec2(-1, 5), glm::vec2(5, -1), glm::vec2(kWidth, 5), glm::vec2(5, 1e9f),
                                 glm::vec2(kNan, 5), glm::vec2(5, kInfinity), glm::vec2(70.5f, kHeight + 3.5f)}) {
    EXPECT_TRUE(test::twoViewpoints().rayPath(pixel).empty());
    EXPECT_FALSE(test::twoViewpoints().unproject({pixel.x, pixel.y, 9}));
  }
  for (const float z : {0.0f, -1.0f, kNan, kInfinity, 11.5f}) {
    EXPECT_FALSE(test::twoViewpoints().unproject({10.5f, 10.5f, z})) << z;
    EXPECT_FALSE(test::twoViewpoints().unproject({7.5f, kHeight + 9.5f, z})) << z;
  }
  for (const glm::vec3& point : {glm::vec3(kNan, 0, 0), glm::vec3(0, kInfinity, 0), glm::vec3(0, 0, 11)}) {
    EXPECT_FALSE(test::twoViewpoints().project(point));
  }
}

}  // namespace
}  // namespace ocelli
