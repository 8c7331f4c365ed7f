#include "oc_core/camera/epipolar_lines.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/error.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// R for the small camera, whose eye L is at (0, 0, 10): to the right, into the scene, away from it, and aslant with
/// the epipole out of the image.
const glm::vec3 kLineRight{1.6f, 0, 10};
const glm::vec3 kForward{0, 0, 8.4f};
const glm::vec3 kBackward{0, 0, 11.6f};
const glm::vec3 kAslant{1, 0.5f, 8.5f};
const glm::vec3 kNearlyRight{1, 0, 9.99f};

TEST(EpipolarLines, ofASegmentAlongTheRowsAreTheRows) {
  const EpipolarLines lines(smallCamera(), kLineRight);
  EXPECT_TRUE(lines.isParallel());
  EXPECT_FALSE(lines.isRing());
  EXPECT_EQ(lines.rowCount(), kHeight);
  EXPECT_EQ(lines.longest(), kWidth);
  const double focal = kHeight / 2.0 * std::sqrt(99.0);
  EXPECT_NEAR(lines.disparity(), focal * 1.6, 1e-3);
  const EpipolarLines::Place place = lines.place({12.5, 7.25});
  EXPECT_EQ(place.row, 7.25);
  EXPECT_EQ(place.position, 12.5);
}

TEST(EpipolarLines, ofAMoveIntoTheSceneAreARingAroundTheMiddle) {
  const EpipolarLines lines(smallCamera(), kForward);
  EXPECT_FALSE(lines.isParallel());
  EXPECT_TRUE(lines.isRing());
  EXPECT_NEAR(lines.epipole().x, kWidth / 2.0, 1e-4);
  EXPECT_NEAR(lines.epipole().y, kHeight / 2.0, 1e-4);
  // A row for each pixel of the circle through the corners; the longest lines run to the corners.
  const double farthest = std::hypot(kWidth / 2.0, kHeight / 2.0);
  EXPECT_NEAR(lines.rowCount(), 2 * kPi * farthest, 2);
  EXPECT_NEAR(lines.longest(), farthest, 1);
  EXPECT_NEAR(lines.disparity(), 1.6, 1e-6);
  // Positions run inwards, and the row that points to the right is half the image's width long.
  const int row = lines.rowOf(lines.place({kWidth, kHeight / 2.0 + 0.01}).row);
  EXPECT_NEAR(lines.length(row), kWidth / 2, 1);
  EXPECT_LT(lines.place({kWidth - 1.0, kHeight / 2.0}).position, lines.place({kWidth - 9.0, kHeight / 2.0}).position);
}

TEST(EpipolarLines, areRadialAndNoRingWhereTheEpipoleIsOutside) {
  const EpipolarLines lines(smallCamera(), kAslant);
  EXPECT_FALSE(lines.isParallel());
  EXPECT_FALSE(lines.isRing());
  // The epipole is the image of the direction (1, 0.5, -1.5).
  const double focal = kHeight / 2.0 * std::sqrt(99.0);
  EXPECT_NEAR(lines.epipole().x, kWidth / 2.0 + focal / 1.5, 1e-3);
  EXPECT_NEAR(lines.epipole().y, kHeight / 2.0 - focal * 0.5 / 1.5, 1e-3);
  EXPECT_GT(lines.rowCount(), kHeight);
}

TEST(EpipolarLines, placesComeBack) {
  for (const glm::vec3& right : {kLineRight, kForward, kBackward, kAslant, kNearlyRight}) {
    const EpipolarLines lines(smallCamera(), right);
    for (double v = 0.25; v < kHeight; v += 1.5) {
      for (double u = 0.25; u < kWidth; u += 1.5) {
        const EpipolarLines::Place place = lines.place({u, v});
        EXPECT_GE(place.row, 0);
        EXPECT_LT(place.row, lines.rowCount());
        const glm::dvec2 back = lines.imagePoint(place);
        EXPECT_NEAR(back.x, u, 1e-7) << right.x << " " << right.z;
        EXPECT_NEAR(back.y, v, 1e-7);
      }
    }
  }
}

// Lines are at most a pixel apart and their samples one pixel: no point of the image is farther from a sample than half
// the diagonal of a pixel. A corner may lie beyond the end of the line that it falls on.
TEST(EpipolarLines, coverTheImage) {
  for (const glm::vec3& right : {kLineRight, kForward, kBackward, kAslant, kNearlyRight}) {
    const EpipolarLines lines(smallCamera(), right);
    int missed = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::dvec2 centre(x + 0.5, y + 0.5);
        const EpipolarLines::Place place = lines.place(centre);
        const int row = lines.rowOf(place.row);
        const double column = std::floor(place.position);
        missed += column < 0 || column >= lines.length(row) ||
                  glm::distance(lines.imagePoint({row + 0.5, column + 0.5}), centre) > std::sqrt(0.5) + 1e-6;
      }
    }
    EXPECT_LE(missed, 4) << right.x << " " << right.z;
  }
}

// What the coordinates are for: seen from a viewpoint t of the way from L to R, a point is at x - t D y.
TEST(EpipolarLines, pointsMoveAlongThemByTheDisparity) {
  for (const glm::vec3& right : {kLineRight, kForward, kBackward, kAslant, kNearlyRight}) {
    const PinholeCamera base = smallCamera();
    const EpipolarLines lines(base, right);
    for (const glm::vec3& point :
         {glm::vec3(0.3f, 0.2f, 0.5f), glm::vec3(-0.5f, 0.4f, -0.7f), glm::vec3(0.1f, -0.6f, 0)}) {
      const ImagePoint q = *base.project(point);
      const EpipolarLines::Place place = lines.place({q.u, q.v});
      const int row = lines.rowOf(place.row);
      const double x = lines.x(row, place.position);
      const double y = lines.inverseZScale(x) / static_cast<double>(q.t);
      for (const float t : {0.25f, 0.5f, 1.0f}) {
        View view = base.view();
        view.eye = base.eye() + (right - base.eye()) * t;
        view.target = view.eye + glm::vec3(0, 0, -10);
        view.fovVerticalDegrees = base.view().resolvedFovVerticalDegrees();
        const ImagePoint moved = *PinholeCamera(view, kWidth, kHeight).project(point);
        const EpipolarLines::Place there = lines.place({moved.u, moved.v});
        EXPECT_NEAR(there.row, place.row, 5e-3) << "it stays on its line";
        const double position = lines.position(row, x - static_cast<double>(t) * lines.disparity() * y);
        EXPECT_NEAR(there.position, position, 2e-3) << "single precision of the projections, " << t;
      }
    }
  }
}

TEST(EpipolarLines, positionsAreOneToOneWithX) {
  for (const glm::vec3& right : {kLineRight, kForward, kBackward, kAslant}) {
    const EpipolarLines lines(smallCamera(), right);
    for (int row = 0; row < lines.rowCount(); row += 7) {
      double last = -1e30;
      for (int j = 0; j < lines.length(row); ++j) {
        const double x = lines.x(row, j + 0.5);
        EXPECT_GT(x, last);
        EXPECT_GT(lines.inverseZScale(x), 0);
        EXPECT_NEAR(lines.position(row, x), j + 0.5, 1e-7);
        last = x;
      }
    }
  }
}

TEST(EpipolarLines, refuseWhatIsNoSegment) {
  const PinholeCamera base = smallCamera();
  EXPECT_THROW(EpipolarLines(base, base.eye()), InputError);
  EXPECT_THROW(EpipolarLines(base, {kNan, 0, 10}), InputError);
  EXPECT_THROW(EpipolarLines(base, {std::numeric_limits<float>::infinity(), 0, 10}), InputError);
  EXPECT_THROW(EpipolarLines(base, {0, 1, 10}), InputError) << "up: the view has to be rolled";
  EXPECT_THROW(EpipolarLines(base, {-1, 0, 10}), InputError) << "to the left";
  EXPECT_THROW(EpipolarLines(PinholeCamera(View{}, 8192, 8192), kForward), InputError) << "too many lines";
  EXPECT_THROW(validate(ViewSegment{{0, 0, 1}, {0, 0, 1}}, "here"), InputError);
}

}  // namespace
}  // namespace ocelli
