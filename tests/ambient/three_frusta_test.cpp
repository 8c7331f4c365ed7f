#include "oc_core/ambient/three_frusta.h"

#include <gmock/gmock.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/camera/graph_overlap.h"
#include "tests/ambient/ambient_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

Mesh longBox() {
  return makeBox({0.2f, 0.3f, 0.9f});
}

std::set<uint32_t> trianglesSeen(const GraphCamera& camera, const Mesh& mesh) {
  std::set<uint32_t> seen;
  for (const Fragment& fragment : raycast(camera, mesh, RayScene(mesh))) {
    if (fragment.covered()) {
      seen.insert(fragment.triangle);
    }
  }
  return seen;
}

PinholeCamera tiltedCamera() {
  View view;
  view.eye = {1, 4, 9};
  return {view, 90, 60};
}

TEST(ThreeFrusta, areThatOfTheViewBeforeThePlane) {
  const GraphCamera camera = threeFrusta(tiltedCamera(), {0, 0, 0}, {{-1, -1, -1}, {1, 1, 1}});
  ASSERT_EQ(camera.frusta().size(), 3u);
  const GraphCamera plain(tiltedCamera());
  Random random(3);
  int before = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 point(random.inRange(-0.5f, 0.5f), random.inRange(-0.5f, 0.5f), random.inRange(-0.5f, 0.5f));
    if (camera.frusta()[1].plane.height(glm::dvec3(point)) >= 0) {
      continue;
    }
    ++before;
    const auto q = camera.project(point);
    const auto p = plain.project(point);
    ASSERT_TRUE(q && p);
    EXPECT_EQ(q->u, p->u);
    EXPECT_EQ(q->v, p->v);
    EXPECT_EQ(camera.frustumOf(glm::dvec3(point)), 0);
  }
  EXPECT_GT(before, 300);
}

TEST(ThreeFrusta, doNotOverlap) {
  const GraphCamera camera = threeFrusta(tiltedCamera(), {0.1, 0, 0.2}, {{-1, -1, -1}, {1, 1, 1}});
  EXPECT_TRUE(overlapsOf(camera, {-2, -2, -2}, {2, 2, 2}).empty());
  // The plane is vertical, and goes through the splitting point.
  for (const size_t i : {1u, 2u}) {
    EXPECT_NEAR(camera.frusta()[i].plane.normal.y, 0, 1e-12);
    EXPECT_NEAR(camera.frusta()[i].plane.height({0.1, 0, 0.2}), 0, 1e-12);
  }
  // Left and right are what they are called.
  const auto middle = [&](size_t i) { return GraphCamera::middleOf(camera.frusta()[i].part).x; };
  EXPECT_EQ(camera.frusta()[1].name, "left");
  EXPECT_LT(middle(1), middle(2));
  const glm::dvec3 right(tiltedCamera().right());
  EXPECT_LT(glm::dot(camera.frusta()[1].viewpoint - glm::dvec3(tiltedCamera().eye()), right), 0);
}

TEST(ThreeFrusta, seeBothSidesOfWhatThePlaneCuts) {
  // Seen along its length the box shows its front alone, and beyond the plane its sides too.
  const Mesh mesh = longBox();
  EXPECT_EQ(trianglesSeen(GraphCamera(smallCamera()), mesh).size(), 2u);
  const GraphCamera camera = threeFrusta(smallCamera(), {0, 0, 0}, boundsOf(mesh));
  EXPECT_EQ(trianglesSeen(camera, mesh).size(), 6u);
}

// Planes through a ray of a frustum stay lines of the image: horizons can be found along them.
TEST(ThreeFrusta, showPlanesThroughTheirRaysAsLines) {
  const GraphCamera camera = threeFrusta(tiltedCamera(), {0, 0, 0.2}, {{-1, -1, -1}, {1, 1, 1}});
  Random random(8);
  for (const size_t i : {0u, 1u, 2u}) {
    const GraphCamera::Frustum& frustum = camera.frusta()[i];
    for (int k = 0; k < 100; ++k) {
      const auto point = [&] {
        return glm::dvec3(random.inRange(-0.5f, 0.5f), random.inRange(-0.5f, 0.5f), random.inRange(-0.5f, 0.5f));
      };
      const glm::dvec3 p = point();
      const glm::dvec3 across = point();
      const auto place = [&](double along, double aside) {
        const glm::dvec4 q =
            frustum.pixelFromWorld * glm::dvec4(p + (p - frustum.viewpoint) * along + across * aside, 1);
        return glm::dvec2(q) / q.w;
      };
      const glm::dvec2 a = place(0, 0);
      const glm::dvec2 b = place(0.01, 0.3) - a;
      const glm::dvec2 c = place(-0.01, 0.8) - a;
      EXPECT_NEAR(b.x * c.y - b.y * c.x, 0, 1e-8 * glm::length(b) * glm::length(c));
    }
  }
}

TEST(ThreeFrusta, areTheViewsOwnWhereAllIsBeforeThePlane) {
  const Mesh mesh = longBox();
  EXPECT_EQ(threeFrusta(smallCamera(), {0, 0, -1}, boundsOf(mesh)).frusta().size(), 1u);
  EXPECT_EQ(threeFrusta(smallCamera(), {0, 0, -0.8}, boundsOf(mesh)).frusta().size(), 3u);
}

TEST(ThreeFrusta, areTwoWhereThePointIsBesideTheImage) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const GraphCamera right = threeFrusta(smallCamera(), {9, 0, 0}, box);
  ASSERT_EQ(right.frusta().size(), 2u);
  EXPECT_EQ(right.frusta()[1].name, "left");
  const GraphCamera left = threeFrusta(smallCamera(), {-9, 0, 0}, box);
  ASSERT_EQ(left.frusta().size(), 2u);
  EXPECT_EQ(left.frusta()[1].name, "right");
}

TEST(ThreeFrusta, refuseWhatTheyCannotDo) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_THROW(threeFrusta(smallCamera(), {0, 0, 11}, box), InputError) << "behind the eye";
  View down;
  down.eye = {0, 10, 0};
  down.up = {0, 0, -1};
  EXPECT_THROW(threeFrusta(PinholeCamera(down, 90, 60), {0, 0, 0}, box), InputError);
}

TEST(SplitCurve, goesBehindWhatIsSeenSideways) {
  const SplitCurve curve(longBox());
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_NEAR(curve.share({0, 0, sign}), 0, 0.05) << "along its length";
    EXPECT_GE(curve.share({sign, 0, 0}), 1) << "from the side";
    EXPECT_NEAR(curve.pointFor({sign, -0.5, 0}).x, sign * curve.offset({sign, 0, 0}), 1e-9);
    EXPECT_EQ(curve.pointFor({sign, -0.5, 0}).y, 0);
  }
  // Seen from the side the camera is the view's own.
  const Box bounds = boundsOf(longBox());
  View side;
  side.eye = {10, 0, 0};
  EXPECT_EQ(threeFrusta(PinholeCamera(side, 90, 60), curve.pointFor({-1, 0, 0}), bounds).frusta().size(), 1u);
}

TEST(SplitCurve, isSmooth) {
  const SplitCurve curve(longBox());
  constexpr int kSteps = 720;
  const auto offset = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / kSteps;
    return curve.offset({std::cos(angle), 0, std::sin(angle)});
  };
  for (int i = 0; i < kSteps; ++i) {
    // Half a degree; the point goes from the middle to the back, 0.3, and the extents grow to 0.9, over 90 degrees.
    EXPECT_NEAR(offset(i + 1), offset(i), 0.02) << i;
  }
}

TEST(SplitCurve, needsVertices) {
  EXPECT_THROW(SplitCurve(Mesh{}), InputError);
}

TEST(WithBorder, keepsThePixels) {
  View view = tiltedCamera().view();
  view.centerShift = {0.2f, -0.1f};
  const PinholeCamera camera(view, 90, 60);
  const PinholeCamera wide = withBorder(camera, 12);
  EXPECT_EQ(wide.width(), 114);
  EXPECT_EQ(wide.height(), 84);
  for (const glm::vec3 point : {glm::vec3(0), glm::vec3(0.5f, -0.3f, 0.8f), glm::vec3(-0.7f, 0.1f, -0.9f)}) {
    const auto q = camera.project(point);
    const auto w = wide.project(point);
    ASSERT_TRUE(q && w);
    EXPECT_NEAR(w->u, q->u + 12, 1e-3);
    EXPECT_NEAR(w->v, q->v + 12, 1e-3);
  }
}

}  // namespace
}  // namespace ocelli
