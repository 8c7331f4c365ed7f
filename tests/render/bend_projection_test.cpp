#include "oc_core/render/bend_projection.h"

#include <gtest/gtest.h>

#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_curved_cameras.h"

namespace ocelli {
namespace {

/// Calls visit(projection, camera, turn, point) for points all over the turns of cameras.
template <class Visit>
void forPointsInTurns(const Visit& visit) {
  test::Numbers numbers;
  for (const CurvedRayCamera& camera : {test::bendingRight(), test::bendingTwice()}) {
    for (size_t turn = 0; turn < camera.bends().size(); ++turn) {
      const BendProjection projection(camera, turn);
      for (int i = 0; i < 2000; ++i) {
        const auto anyPoint = [&] {
          const BendCorners c = cornersOf(camera, turn, {numbers.between(0, 90), numbers.between(0, 60)});
          const double t = numbers.between(0.001, 0.999);
          return c.t * (1 - t) * (1 - t) + c.s * 2.0 * t * (1 - t) + c.q * t * t;
        };
        visit(projection, camera, turn, anyPoint(), anyPoint());
      }
    }
  }
}

TEST(BendProjection, agreesWithTheCamera) {
  size_t seen = 0;
  forPointsInTurns([&](const BendProjection& projection, const CurvedRayCamera& camera, size_t turn,
                       const glm::dvec3& point, const glm::dvec3& /*other*/) {
    const std::optional<RayTransition::Place> place = camera.bends()[turn].find(point);
    const BendImage image = projection.project(point);
    ASSERT_EQ(image.imaged, place.has_value());
    if (place) {
      const glm::dvec4 h = camera.pixelFromWorld(turn) * glm::dvec4(place->arc.s, 1);
      EXPECT_LT(glm::distance(image.pixel, {h.x / h.w, h.y / h.w}), 1e-9);
      EXPECT_GT(image.weight, 0);
      ++seen;
    }
  });
  EXPECT_GT(seen, 5000u);
}

// The factor is measured on other edges than these.
TEST(BendProjection, noEdgeBendsMoreThanItSays) {
  double most = 0;
  forPointsInTurns(
      [&](const BendProjection& projection, const CurvedRayCamera&, size_t, const glm::dvec3& a, const glm::dvec3& b) {
        for (const double length : {1.0, 0.3, 0.05}) {
          const glm::dvec3 end = a + (b - a) * length;
          const BendImage imageA = projection.project(a);
          const BendImage imageB = projection.project(end);
          const double bend = projection.deviation(imageA, imageB, projection.project((a + end) * 0.5));
          EXPECT_LE(bend, projection.greatestBend(glm::distance(imageA.pixel, imageB.pixel),
                                                  std::abs(imageA.share() - imageB.share())) +
                              1e-9);
          most = std::max(most, bend);
        }
      });
  EXPECT_GT(most, 1);
}

// Edges in a plane through the line of the turn stay straight: the map of such a plane is projective.
TEST(BendProjection, edgesThatPassNoShareStayStraight) {
  forPointsInTurns([&](const BendProjection& projection, const CurvedRayCamera& camera, size_t turn,
                       const glm::dvec3& a, const glm::dvec3& b) {
    // The point of the line from b along the normal of the last plane that has the share of a.
    const TransitionPlanes& planes = camera.bends()[turn].planes();
    const double share = projection.project(a).share();
    const glm::dvec3 across = glm::normalize(planes.from.normal + planes.to.normal);
    const auto excess = [&](const glm::dvec3& p) {
      return planes.from.height(p) * (1 - share) + planes.to.height(p) * share;  // 0 where the share is that
    };
    const glm::dvec3 end = b - across * (excess(b) / (excess(b + across) - excess(b)));
    const BendImage imageA = projection.project(a);
    const BendImage imageB = projection.project(end);
    const BendImage middle = projection.project((a + end) * 0.5);
    if (imageB.imaged && middle.imaged && glm::distance(imageA.pixel, imageB.pixel) < 100) {
      const glm::dvec2 along = glm::normalize(imageB.pixel - imageA.pixel);
      const glm::dvec2 off = middle.pixel - imageA.pixel;
      EXPECT_LT(std::abs(along.x * off.y - along.y * off.x), 1e-6);
    }
  });
}

}  // namespace
}  // namespace ocelli
