#include "oc_core/camera/epipolar_camera.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/camera/random_edges.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;
using RowEdges = std::vector<std::vector<EpipolarEdge>>;

const glm::vec3 kRight{1.6f, 0, 10};
constexpr int kRow = 30;

/// An occluder at depth 9 that ends at column 50, before a background at depth 11.
EpipolarCamera oneEdge(int clip = 40) {
  const EpipolarLines lines(smallCamera(), kRight);
  RowEdges rows(kHeight);
  // D (1/9 - 1/11) = 9.65 pixels: ten columns put z_f a little beyond 11.
  rows[kRow] = {{50, clip, 10, 1 / 9.0f}};
  return {smallCamera(), kRight, rows};
}

glm::vec3 pointAt(double u, double z) {
  return *smallCamera().unproject({static_cast<float>(u), kRow + 0.5f, static_cast<float>(z)});
}

double columnOf(const EpipolarCamera& camera, double u, double z) {
  return static_cast<double>(camera.project(pointAt(u, z))->u);
}

/// Image coordinates of 90 pixels, from world coordinates of 10 units.
constexpr double kRounding = 2e-4;

// By hand, for one edge: D = f 1.6 with f = 30 sqrt(99); z_f follows from the ten columns.
TEST(EpipolarCamera, projectsAsDerivedByHand) {
  const EpipolarCamera camera = oneEdge();
  const double disparity = 30 * std::sqrt(99.0) * 1.6;
  EXPECT_EQ(camera.width(), kWidth + 10);
  EXPECT_EQ(camera.height(), kHeight);
  EXPECT_EQ(camera.rowWidth(kRow), kWidth + 10);
  EXPECT_EQ(camera.rowWidth(kRow + 1), kWidth);
  // What L sees: before the edge as it is, behind the edge moved by the added columns.
  EXPECT_NEAR(columnOf(camera, 30, 11), 30, kRounding);
  EXPECT_NEAR(columnOf(camera, 45, 9), 45, kRounding);
  EXPECT_NEAR(columnOf(camera, 60, 11), 70, kRounding);
  // In the disocclusion, beyond z_f: as L would see it, in the added columns.
  const double inverseFar = 1 / 9.0 - 10 / disparity;
  EXPECT_NEAR(columnOf(camera, 45, 1 / inverseFar + 0.5), 55, kRounding);
  // In the disocclusion, before z_f: along the ray of R.
  const double w = 0.5 * (1 / 9.0 + inverseFar);
  EXPECT_NEAR(columnOf(camera, 49, 1 / w), 49 + 10 - disparity * (w - inverseFar), kRounding);
  // Behind the occluder, but no viewpoint of the segment sees it: it stays.
  EXPECT_NEAR(columnOf(camera, 46, 9.1), 46, kRounding);
  // Other rows know nothing of it.
  EXPECT_NEAR(camera.project(*smallCamera().unproject({45, kRow + 1.5f, 12}))->u, 45, kRounding);
}

TEST(EpipolarCamera, raysBendAtTheDepthOfTheBackground) {
  const EpipolarCamera camera = oneEdge();
  const PinholeCamera base = smallCamera();
  const RayPath path = camera.rayPath({55.5f, kRow + 0.5f});  // L sees it at 45.5
  ASSERT_EQ(path.size(), 3u);
  // It begins just before the next ray of L, at 50.5, and reaches 45.5 at z_f.
  const ImagePoint start = base.imageFromCamera(base.cameraFromWorld(path[0]));
  const ImagePoint knee = base.imageFromCamera(base.cameraFromWorld(path[1]));
  const ImagePoint end = base.imageFromCamera(base.cameraFromWorld(path[2]));
  EXPECT_NEAR(start.u, 50.5, 0.02);
  EXPECT_NEAR(knee.u, 45.5, kRounding);
  EXPECT_NEAR(end.u, 45.5, kRounding);
  const double disparity = camera.lines().disparity();
  EXPECT_NEAR(1 / knee.t, 1 / 9.0 - 10 / disparity, 1e-6);
  EXPECT_NEAR(end.t, base.view().zFar, 1e-3);
  // The first part is a ray of R: R, its start and its knee are on a line.
  const glm::vec3 a = glm::normalize(path[0] - kRight);
  const glm::vec3 b = glm::normalize(path[1] - kRight);
  EXPECT_LT(glm::length(glm::cross(a, b)), 1e-6f);
}

TEST(EpipolarCamera, raysOfLEndWhereTheDisocclusionBegins) {
  const EpipolarCamera camera = oneEdge();
  const PinholeCamera base = smallCamera();
  const RayPath path = camera.rayPath({45.5f, kRow + 0.5f});
  ASSERT_EQ(path.size(), 2u);
  const double disparity = camera.lines().disparity();
  EXPECT_NEAR(1 / base.cameraFromWorld(path[1]).z, 1 / 9.0 - (50 - 45.5) / disparity, 1e-5);
  EXPECT_FALSE(camera.unproject({45.5f, kRow + 0.5f, 12}));
  EXPECT_TRUE(camera.unproject({45.5f, kRow + 0.5f, 9.05f}));
}

TEST(EpipolarCamera, clippedDisocclusionsLeaveColumnsThatEndEarly) {
  const EpipolarCamera camera = oneEdge(46);  // the occluder is four pixels wide
  const PinholeCamera base = smallCamera();
  // This ray of R would reach 42.5 at z_f. It ends at 46.5, the centre of the first pixel in the disocclusion.
  const RayPath path = camera.rayPath({52.5f, kRow + 0.5f});
  ASSERT_EQ(path.size(), 2u);
  EXPECT_NEAR(base.imageFromCamera(base.cameraFromWorld(path[1])).u, 46.5, 0.02);
  // What is to the left of that is in no disocclusion.
  EXPECT_NEAR(columnOf(camera, 44, 12), 44, kRounding);
}

TEST(EpipolarCamera, columnsBeyondARowHaveNoRay) {
  const EpipolarCamera camera = oneEdge();
  EXPECT_TRUE(camera.rayPath({kWidth + 5.5f, kRow + 1.5f}).empty());
  EXPECT_FALSE(camera.unproject({kWidth + 5.5f, kRow + 1.5f, 10}));
  EXPECT_FALSE(camera.rayPath({kWidth + 5.5f, kRow + 0.5f}).empty());
}

// A row is a bijection: a point that is unprojected from a column projects to it, and whatever projects comes back.
TEST(EpipolarCamera, rowsAreBijectionsWhateverTheirEdges) {
  const PinholeCamera base = smallCamera();
  for (const glm::vec3& right : test::segmentEnds()) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const EpipolarLines lines(base, right);
      const EpipolarCamera camera(base, right, test::randomEdges(lines, seed));
      size_t points = 0;
      size_t lost = 0;
      for (int row = 0; row < lines.rowCount(); row += 5) {
        for (int j = 0; j < lines.length(row); ++j) {
          for (const double z : {6.5, 8.0, 8.7, 9.3, 9.9, 10.6, 11.5, 14.0}) {
            const glm::dvec2 p = lines.imagePoint({row + 0.5, j + 0.5});
            const glm::vec3 point =
                *base.unproject({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(z)});
            const std::optional<ImagePoint> q = camera.project(point);
            ASSERT_TRUE(q);
            const std::optional<glm::vec3> back = camera.unproject(*q);
            ++points;
            // Within 1e-3 pixels of the border of a disocclusion a ray may have ended.
            lost += !back;
            if (back) {
              EXPECT_LT(glm::distance(*back, point), 2e-4f) << row << " " << j << " " << z;
            }
          }
        }
      }
      EXPECT_LE(lost, points / 500);
    }
  }
}

TEST(EpipolarCamera, theRightmostDisocclusionWins) {
  const EpipolarLines lines(smallCamera(), kRight);
  RowEdges rows(kHeight);
  rows[kRow] = {{40, 20, 18, 1 / 9.0f}, {50, 20, 28, 1 / 8.8f}};
  const EpipolarCamera camera(smallCamera(), kRight, rows);
  EXPECT_EQ(camera.width(), kWidth + 46);
  const double disparity = lines.disparity();
  // Far behind, both disocclusions hold the point.
  EXPECT_NEAR(columnOf(camera, 38, 20), 38 + 46, kRounding);
  // Half a pixel of R's image behind the first edge, where nobody sees past the second one: the first column added.
  const double w = 1 / 9.0 - 0.6 / disparity;
  EXPECT_NEAR(columnOf(camera, 39.9, 1 / w), 40 - 18 + 0.5 + 18, 5e-3);
}

TEST(EpipolarCamera, refusesMoreColumnsThanAnImageMayHave) {
  RowEdges rows(kHeight);
  rows[kRow] = {{50, 40, 2'000'000, 1 / 9.0f}};
  EXPECT_THROW(EpipolarCamera(smallCamera(), kRight, rows), InputError);
}

TEST(EpipolarCameraDeathTest, edgesThatMakeNoSenseAreBugs) {
  const auto make = [](const std::vector<EpipolarEdge>& edges) {
    RowEdges rows(kHeight);
    rows[kRow] = edges;
    return EpipolarCamera(smallCamera(), kRight, rows);
  };
  EXPECT_DEATH(make({{50, 50, 4, 0.1f}}), "edges come from left to right");
  EXPECT_DEATH(make({{50, 40, 0, 0.1f}}), "edges come from left to right");
  EXPECT_DEATH(make({{50, 40, 4, 0.1f}, {50, 41, 4, 0.1f}}), "edges come from left to right");
  EXPECT_DEATH(make({{kWidth + 1, 40, 4, 0.1f}}), "edges come from left to right");
  EXPECT_DEATH(EpipolarCamera(smallCamera(), kRight, RowEdges(3)), "one list of edges");
}

}  // namespace
}  // namespace ocelli
