#include "oc_core/camera/curved_ray_camera.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/camera/inverse_errors.h"
#include "tests/camera/random_curved_cameras.h"
#include "tests/camera/test_curved_cameras.h"

namespace ocelli {
namespace {

using test::bendingRight;
using test::bendingTwice;
using test::InverseErrors;
using test::Numbers;
using test::planesThrough;
using test::rightTurn;
using test::smallCamera;
using test::worstInverse;
using testing::HasSubstr;

std::string messageOfBend(const TransitionPlanes& planes, const glm::dvec3& viewpoint) {
  try {
    CurvedRayCamera(smallCamera()).bend(planes, viewpoint);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// Where the line through a and b meets that through c and d, all in a plane.
glm::dvec3 meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const glm::dvec3 normal = glm::cross(b - a, glm::cross(b - a, d - c));
  return c + (d - c) * (glm::dot(normal, a - c) / glm::dot(normal, d - c));
}

TEST(CurvedRayCamera, projectionAndRaysAreInverse) {
  for (const CurvedRayCamera& camera :
       {bendingRight(), bendingTwice(), bendingTwice(PinholeCamera(View{}, 1920, 1200))}) {
    size_t inTurns = 0;
    const InverseErrors worst = worstInverse(camera, [&](const glm::dvec3& point) {
      const TransitionPlanes& planes = camera.bends()[0].planes();
      inTurns += planes.from.height(point) > 0 && planes.to.height(point) < 0;
    });
    EXPECT_GT(inTurns, 50000u);
    EXPECT_LT(worst.pixel, 1e-6);
    EXPECT_LT(worst.point, 1e-6);
  }
}

// The five steps of section 4.2.2.1, as the text has them.
TEST(CurvedRayCamera, projectsAsTheTextDoes) {
  const CurvedRayCamera camera = bendingRight();
  const RayTransition& turn = camera.bends()[0];
  const glm::dvec3 c0 = turn.before();
  const glm::dvec3 c1 = turn.beyond();
  Numbers numbers;
  size_t points = 0;
  while (points < 1000) {
    const glm::dvec3 p(numbers.between(-2, 3), numbers.between(-1, 1), numbers.between(-2, 2));
    if (turn.planes().from.height(p) < 0.01 || turn.planes().to.height(p) > -0.01) {
      continue;
    }
    const auto place = turn.find(p);
    if (!place || !camera.projectExactly(p) || camera.projectExactly(p)->u < 0) {
      continue;
    }
    ++points;
    // The epipolar plane: A, and an arc b other than that of P: the Bezier arc of Equation 4.1, which is that of the
    // border. Its rays pass the corner of the image at the left.
    const glm::dvec3 normal = glm::cross(c1 - c0, p - c0);
    const auto onVertical = [&](const glm::dvec3& at) {
      return at + glm::dvec3(0, 1, 0) * (glm::dot(normal, c0 - at) / normal.y);
    };
    const glm::dvec3 a = onVertical({4, 0, 0});
    const ExactImagePoint corner{0, 0, 1};
    const glm::dvec3 onCornerRay = *camera.unprojectExactly(corner);
    const glm::dvec3 s = onVertical(turn.planes().middle.crossing(c0, onCornerRay));
    const glm::dvec3 t = turn.planes().from.crossing(c0, s);
    const glm::dvec3 q = turn.planes().to.crossing(c1, s);
    // Step 1, by bisection.
    double below = 0;
    double above = 1;
    const auto onB = [&](double u) { return t * (1 - u) * (1 - u) + s * 2.0 * u * (1 - u) + q * u * u; };
    const auto side = [&](double u) { return glm::dot(normal, glm::cross(p - a, onB(u) - a)); };
    const bool rising = side(1) > side(0);
    for (int i = 0; i < 100; ++i) {
      const double middle = (below + above) / 2;
      ((side(middle) > 0) == rising ? above : below) = middle;
    }
    const glm::dvec3 pn = onB(below);
    // Steps 2 to 4.
    const glm::dvec3 r = meet(pn, q, c0, c1);
    const glm::dvec3 ownQ = turn.planes().to.crossing(r, p);
    const glm::dvec3 ownS = turn.planes().middle.crossing(c1, ownQ);
    EXPECT_LT(glm::distance(ownS, place->arc.s), 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

TEST(CurvedRayCamera, raysAreSmoothAtBothEndsOfATurn) {
  const CurvedRayCamera camera = bendingRight();
  const RayTransition& turn = camera.bends()[0];
  for (double v = 0; v <= camera.height(); v += 5) {
    for (double u = 0; u <= camera.width(); u += 5) {
      const glm::dvec3 s = turn.planes().middle.crossing(turn.before(), *camera.unprojectExactly({u, v, 1}));
      const RayTransition::Arc arc = turn.arcThrough(s);
      const auto angle = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::length(glm::cross(glm::normalize(a), glm::normalize(b)));
      };
      EXPECT_LT(angle(arc.tangent(0), s - turn.before()), 1e-9);
      EXPECT_LT(angle(arc.tangent(1), arc.q - turn.beyond()), 1e-9);
      // The same by differences, from both sides.
      constexpr double kStep = 1e-6;
      EXPECT_LT(angle(arc.at(kStep) - arc.at(0), s - turn.before()), 1e-4);
      EXPECT_LT(angle(arc.at(1) - arc.at(1 - kStep), arc.q - turn.beyond()), 1e-4);
    }
  }
}

// The ray of the border is the Bezier arc of Equation 4.1; the others are nearly.
TEST(CurvedRayCamera, pointsOfAnArcAtOnceAreThoseOneByOne) {
  for (const ArcModel model : {ArcModel::kConic, ArcModel::kBezier}) {
    const CurvedRayCamera camera = test::bendingTwice(test::smallCamera(), model);
    const RayTransition& turn = camera.bends()[0];
    for (const glm::dvec2& pixel : {glm::dvec2(0, 0), glm::dvec2(31, 44), glm::dvec2(90, 60)}) {
      const glm::dvec3 s =
          turn.planes().middle.crossing(turn.before(), *camera.unprojectExactly({pixel.x, pixel.y, 1}));
      const RayTransition::Arc arc = turn.arcThrough(s);
      RayTransition::ArcPoints points;
      turn.pointsOf(arc, 24, points);
      for (size_t k = 0; k < 24; ++k) {
        const double parameter = static_cast<double>(k) / 23;
        EXPECT_LT(glm::distance(glm::dvec3(points.x[k], points.y[k], points.z[k]), arc.at(parameter)), 1e-12);
        EXPECT_NEAR(points.share[k], turn.shareAt({arc, parameter}), 1e-12);
      }
    }
  }
}

TEST(CurvedRayCamera, arcsAreNearlyThoseOfTheUnmodifiedModel) {
  const CurvedRayCamera camera = bendingRight();
  const RayTransition& turn = camera.bends()[0];
  for (double u = 0; u <= camera.width(); u += 5) {
    const glm::dvec3 s = turn.planes().middle.crossing(turn.before(), *camera.unprojectExactly({u, 30, 1}));
    const RayTransition::Arc arc = turn.arcThrough(s);
    for (double at = 0; at <= 1; at += 0.125) {
      const glm::dvec3 bezier = arc.t * (1 - at) * (1 - at) + arc.s * 2.0 * at * (1 - at) + arc.q * at * at;
      EXPECT_LT(glm::distance(bezier, arc.at(at)), u == 0 ? 1e-12 : 0.03 * arc.length());
    }
  }
}

// The text's first model: every ray is the arc of Equation 4.1, and its projection undoes that.
TEST(CurvedRayCamera, bezierArcsAreThoseOfTheEquation) {
  const CurvedRayCamera camera = test::bendingTwice(test::smallCamera(), ArcModel::kBezier);
  const CurvedRayCamera conic = test::bendingTwice();
  Numbers numbers;
  double farthest = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 pixel(numbers.between(0, 90), numbers.between(0, 60));
    const RayTransition& turn = camera.bends()[0];
    const glm::dvec3 s = turn.planes().middle.crossing(turn.before(), *camera.unprojectExactly({pixel.x, pixel.y, 1}));
    const RayTransition::Arc arc = turn.arcThrough(s);
    const double at = numbers.between(0, 1);
    const glm::dvec3 bezier = arc.t * (1 - at) * (1 - at) + arc.s * 2.0 * at * (1 - at) + arc.q * at * at;
    EXPECT_LT(glm::distance(bezier, arc.at(at)), 1e-12);
    const auto image = camera.projectExactly(bezier);
    ASSERT_TRUE(image);
    EXPECT_LT(glm::distance(glm::dvec2(image->u, image->v), pixel), 1e-9);
    const auto seen = conic.projectExactly(bezier);
    ASSERT_TRUE(seen);
    farthest = std::max(farthest, glm::distance(glm::dvec2(seen->u, seen->v), pixel));
  }
  EXPECT_GT(farthest, 0.01) << "the models differ";
  EXPECT_LT(farthest, 1) << "but by less than a pixel here: they look the same (Figure 4.13)";
}

// Two rays come no nearer to each other in a turn than a share of what they are apart where it begins.
TEST(CurvedRayCamera, raysDoNotCross) {
  for (const CurvedRayCamera& camera : {bendingRight(), bendingTwice()}) {
    Numbers numbers;
    for (int pair = 0; pair < 100000; ++pair) {
      const glm::dvec2 a(numbers.between(0, camera.width()), numbers.between(0, camera.height()));
      const glm::dvec2 b(numbers.between(0, camera.width()), numbers.between(0, camera.height()));
      const double z = numbers.between(8, 16);
      // A point of one ray projects to that ray alone.
      const glm::dvec3 point = *camera.unprojectExactly({a.x, a.y, z});
      const ExactImagePoint q = *camera.projectExactly(point);
      ASSERT_LT(glm::distance(glm::dvec2(q.u, q.v), a), 1e-6 * camera.width());
      ASSERT_GT(glm::distance(glm::dvec2(q.u, q.v), b) + 1e-6 * camera.width(), glm::distance(a, b));
      ASSERT_GT(glm::distance(point, *camera.unprojectExactly({b.x, b.y, z})), 1e-9 * glm::distance(a, b));
    }
  }
}

TEST(CurvedRayCamera, withoutABendItIsThePinhole) {
  const PinholeCamera pinhole = smallCamera();
  CurvedRayCamera straight(pinhole);
  straight.bend(rightTurn(), glm::dvec3(0, 0, 10));
  Numbers numbers;
  for (const CurvedRayCamera& camera : {CurvedRayCamera(pinhole), straight}) {
    for (int i = 0; i < 10000; ++i) {
      const glm::vec3 point(numbers.between(-0.8, 0.8), numbers.between(-0.5, 0.5), numbers.between(-20, 5));
      const auto expected = pinhole.project(point);
      const auto got = camera.project(point);
      ASSERT_TRUE(expected && got);
      EXPECT_NEAR(got->u, expected->u, 1e-3);
      EXPECT_NEAR(got->v, expected->v, 1e-3);
      EXPECT_NEAR(got->t / expected->t, 1, 1e-5);
    }
  }
}

TEST(CurvedRayCamera, seesNothingFarBeyondTheBorders) {
  EXPECT_FALSE(bendingRight().unprojectExactly({10, 3e160, 15})) << "where rays have no coordinates";
}

// A turn may end behind zFar; rays do not run back to there.
TEST(CurvedRayCamera, raysNeverRunBack) {
  View view;
  view.zFar = 10.5f;
  CurvedRayCamera camera(PinholeCamera(view, 90, 60));
  camera.bend(rightTurn(), {-2, 0, 6});
  const RayPath path = camera.rayPath({10, 30});
  for (size_t i = 2; i < path.size(); ++i) {
    EXPECT_GE(glm::dot(path[i] - path[i - 1], path[i - 1] - path[i - 2]), 0.0f) << i;
  }
}

/// The greatest distance of points of the finest polyline of some rays from one of so many corners.
float deviationOfPolylines(const CurvedRayCamera& camera, size_t arcPoints) {
  float greatest = 0;
  for (float u = 5; u < static_cast<float>(camera.width()); u += 11) {
    for (float v = 5; v < static_cast<float>(camera.height()); v += 11) {
      const RayPath coarse = camera.rayPath({u, v}, arcPoints);
      for (const glm::vec3& point : camera.rayPath({u, v}, CurvedRayCamera::kArcPoints)) {
        greatest = std::max(greatest, glm::distance(coarse.pointAt(coarse.positionNear(point)), point));
      }
    }
  }
  return greatest;
}

TEST(CurvedRayCamera, FewerPointsOfAnArcLieOnItAndStayAsNearAsIsAsked) {
  Numbers numbers;
  int fewer = 0;
  for (int i = 0; i < 30; ++i) {
    const CurvedRayCamera camera = test::randomCurved(numbers, 2);
    size_t pointsBefore = 0;
    for (const double deviation : {0.1, 0.03, 0.01, 0.003}) {
      const size_t points = camera.arcPointsWithin(deviation);
      EXPECT_GE(points, pointsBefore);
      EXPECT_LE(points, CurvedRayCamera::kArcPoints);
      pointsBefore = points;
      fewer += points < CurvedRayCamera::kArcPoints ? 1 : 0;
      // The grid of rays that it asks does not hold the worst one, nor are the chords' middles the farthest points.
      EXPECT_LT(deviationOfPolylines(camera, points), 1.1 * deviation + 1e-5) << points;
    }
  }
  EXPECT_GT(fewer, 60);
  const CurvedRayCamera camera = bendingRight();
  const RayPath path = camera.rayPath({20, 20}, 5);
  const RayPath finest = camera.rayPath({20, 20}, 17);  // every fourth point is one of five
  ASSERT_EQ(path.size(), 7u);
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    EXPECT_LT(glm::distance(path[i], finest[1 + 4 * (i - 1)]), 1e-5f);
    EXPECT_NEAR(path.t(i), finest.t(1 + 4 * (i - 1)), 1e-5f);
  }
}

TEST(CurvedRayCamera, refusesWhatCannotBe) {
  EXPECT_THAT(messageOfBend({Plane::through({4, 0, 0}, {-0.25, 0, -1}), Plane::through({4, 0, 0}, {0, 0.3, -1}),
                             Plane::through({4, 0, 0}, {0.25, 0, -1})},
                            {-2, 0, 6}),
              HasSubstr("turn 1: its planes do not meet in a line"));
  EXPECT_THAT(messageOfBend({Plane::through({4, 0, 0}, {-0.25, 0, -1}), Plane::through({4, 0, 1}, {0, 0, -1}),
                             Plane::through({4, 0, 0}, {0.25, 0, -1})},
                            {-2, 0, 6}),
              HasSubstr("do not meet in a line"));
  EXPECT_THAT(messageOfBend({Plane::through({0, 0, 1}, {0, 0, -1}), Plane::through({0, 0, 0}, {0, 0, -1}),
                             Plane::through({0, 0, -1}, {0, 0, -1})},
                            {-2, 0, 6}),
              HasSubstr("parallel"));
  EXPECT_THAT(messageOfBend({{{0, 0, 2}, 0}, {{0, 0, 1}, 0}, {{0, 0, 1}, 0}}, {0, 0, 5}), HasSubstr("not finite"));
  EXPECT_THAT(messageOfBend({{{0, 0, 1}, NAN}, {{0, 0, 1}, 0}, {{0, 0, 1}, 0}}, {0, 0, 5}), HasSubstr("not finite"));
  EXPECT_THAT(messageOfBend(rightTurn(), {-2, 0, -6}), HasSubstr("viewpoint does not lie before"));
  EXPECT_THAT(messageOfBend(rightTurn(), {-2, NAN, 6}), HasSubstr("viewpoint"));
  EXPECT_THAT(messageOfBend(rightTurn(), {-2, 1e40, 6}), HasSubstr("too far away for single precision"));
  EXPECT_THAT(messageOfBend(planesThrough({4, 0, 20}, {-0.25, 0, -1}, {0, 0, -1}, {0.25, 0, -1}), {0, 0, 30}),
              HasSubstr("not every ray"))
      << "behind the eye";
  EXPECT_THAT(messageOfBend(planesThrough({0.2, 0, 0}, {-0.25, 0, -1}, {0, 0, -1}, {0.25, 0, -1}), {-2, 0, 6}),
              HasSubstr("not every ray"))
      << "the line runs through the image";
  EXPECT_THAT(messageOfBend(rightTurn(), {0, 2, 10}), HasSubstr("along the line where its planes meet"));
  CurvedRayCamera camera = bendingRight();
  EXPECT_THROW(camera.bend(rightTurn(), {-2, 0, 6}), InputError) << "before the turn that is there already";
  EXPECT_EQ(camera.bends().size(), 1u);
}

}  // namespace
}  // namespace ocelli
