#include "oc_core/camera/graph_camera.h"

#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using test::crossroads;
using test::InverseErrors;
using test::Numbers;
using test::smallCamera;
using test::turnAt;
using test::worstInverse;
using testing::HasSubstr;

template <class Make>
std::string messageOf(const Make& make) {
  try {
    make();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

/// Split, and merged again behind an object (Figure 4.6).
GraphCamera aroundObject() {
  GraphCamera graph(smallCamera());
  const auto [left, right] = graph.split(0, turnAt({0, 0, 1}, {-0.2, 0, -1}, {0.8, 0, 8}),
                                         turnAt({0, 0, 1}, {0.2, 0, -1}, {-0.8, 0, 8}), "left", "right");
  graph.merge(left, right, turnAt({0, 0, -1.5}, {0, 0, -1}, {0, 0, 6}), "behind");
  return graph;
}

TEST(GraphCamera, theRootAloneIsThePinhole) {
  const PinholeCamera pinhole = smallCamera();
  const GraphCamera graph(pinhole);
  Numbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec3 point(numbers.between(-3, 3), numbers.between(-3, 3), numbers.between(-50, 9.9));
    const auto expected = pinhole.project(point);
    const auto got = graph.project(point);
    ASSERT_TRUE(expected && got);
    EXPECT_NEAR(got->u, expected->u, 1e-3 * std::max(1.0f, std::abs(expected->u) / 100));
    EXPECT_NEAR(got->v, expected->v, 1e-3 * std::max(1.0f, std::abs(expected->v) / 100));
    EXPECT_NEAR(got->t / expected->t, 1, 1e-6);
  }
}

// Appendix A, by hand: a point beyond the plane z = 0 is seen where its line to C' = (1, 0, 5) crosses that plane, by
// the eye at (0, 0, 10).
TEST(GraphCamera, bendByHand) {
  const PinholeCamera pinhole = smallCamera();
  GraphCamera graph(pinhole);
  EXPECT_EQ(graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {1, 0, 5}), "bent"), 1);
  // (0.2, 0.1, -5): half way to C' at (0.6, 0.05, 0).
  const glm::vec3 point(0.2f, 0.1f, -5);
  const auto expected = pinhole.project({0.6f, 0.05f, 0});
  const auto got = graph.project(point);
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->u, expected->u, 1e-4);
  EXPECT_NEAR(got->v, expected->v, 1e-4);
  // Ray lengths |(0.6, 0.05, -10)| and |(-0.4, 0.05, -5)|, times the cosine 10 / |(0.6, 0.05, -10)|.
  EXPECT_NEAR(got->t, 10 * (1 + std::sqrt(0.16 + 0.0025 + 25) / std::sqrt(0.36 + 0.0025 + 100)), 1e-5);
  EXPECT_EQ(graph.frustumOf(point), 1);
  EXPECT_EQ(graph.frustumOf({0, 0, 1}), 0);
  const RayPath path = graph.rayPath({got->u, got->v});
  ASSERT_EQ(path.size(), 3u);
  EXPECT_LT(glm::distance(path[1], glm::vec3(0.6f, 0.05f, 0)), 1e-5f);
  EXPECT_LT(glm::length(glm::cross(glm::normalize(path[2] - path[1]), glm::normalize(point - path[1]))), 1e-6f);
}

TEST(GraphCamera, projectionAndRaysAreInverse) {
  const PinholeCamera large(View{}, 1920, 1200);
  for (const GraphCamera& graph : {crossroads(), aroundObject(), crossroads(large)}) {
    size_t turned = 0;
    const InverseErrors worst =
        worstInverse(graph, [&](const glm::dvec3& point) { turned += graph.frustumOf(point) > 0; });
    EXPECT_GT(turned, 400000u);
    EXPECT_LT(worst.pixel, 1e-6);
    EXPECT_LT(worst.point, 1e-6);
  }
}

TEST(GraphCamera, partsHaveAMiddle) {
  EXPECT_EQ(GraphCamera::middleOf({{0, 0}, {90, 0}, {90, 60}, {0, 60}}), glm::dvec2(45, 30));
  EXPECT_EQ(GraphCamera::middleOf({{0, 0}, {8, 0}, {4, 4}, {0, 8}}), glm::dvec2(3, 3));
}

// A point that moves from one frustum into the next moves on in the image without a jump.
TEST(GraphCamera, imagesAreContinuousAcrossPlanes) {
  const GraphCamera graph = crossroads();
  for (size_t i = 1; i < graph.frusta().size(); ++i) {
    const GraphCamera::Frustum& frustum = graph.frusta()[i];
    const RayPath path = graph.rayPath(glm::vec2(GraphCamera::middleOf(frustum.part)));
    for (size_t k = 1; k + 1 < path.size(); ++k) {
      const glm::dvec3 at(path[k]);
      const auto before = graph.projectExactly(at - frustum.plane.normal * 1e-6);
      const auto beyond = graph.projectExactly(at + frustum.plane.normal * 1e-6);
      ASSERT_TRUE(before && beyond);
      EXPECT_NEAR(before->u, beyond->u, 1e-2);
      EXPECT_NEAR(before->v, beyond->v, 1e-2);
      EXPECT_NEAR(before->t, beyond->t, 1e-4);
    }
  }
}

TEST(GraphCamera, splitGoesAlongTheLineWhereThePlanesMeet) {
  const GraphCamera graph = crossroads();
  ASSERT_EQ(graph.frusta().size(), 4u);
  const double middle = graph.width() / 2.0;
  for (const glm::dvec2& corner : graph.frusta()[1].part) {
    EXPECT_LE(corner.x, middle + 1e-9) << "left";
  }
  for (const glm::dvec2& corner : graph.frusta()[2].part) {
    EXPECT_GE(corner.x, middle - 1e-9) << "right";
  }
  EXPECT_EQ(graph.frusta()[3].parent, 1);
}

TEST(GraphCamera, mergeLooksFromOneViewpoint) {
  const GraphCamera graph = aroundObject();
  ASSERT_EQ(graph.frusta().size(), 5u);
  EXPECT_EQ(graph.frusta()[3].viewpoint, graph.frusta()[4].viewpoint);
  // Between the two is the occlusion shadow of what stands on the axis: 0.38 to each side.
  EXPECT_EQ(graph.frustumOf({0, 0, -4}), -1);
  EXPECT_EQ(graph.frustumOf({-0.6, 0, -4}), 3);
  EXPECT_EQ(graph.frustumOf({0.6, 0, -4}), 4);
}

TEST(GraphCamera, raysThatNoChildTakesGoStraightOn) {
  GraphCamera graph(smallCamera());
  graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {1, 0, 5}), "window", {{30, 20}, {60, 20}, {60, 40}, {30, 40}});
  EXPECT_EQ(graph.rayPath({45, 30}).size(), 3u);
  EXPECT_EQ(graph.rayPath({10, 10}).size(), 2u);
  EXPECT_EQ(graph.frustumOf(glm::dvec3(*graph.unproject({10, 10, 20}))), 0);
}

TEST(GraphCamera, raysEndAtLimits) {
  GraphCamera graph(smallCamera());
  const int bent = graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {0, 0, 5}), "bent");
  graph.limit(bent, Plane::through({0, 0, -2}, {0, 0, -1}));
  graph.limit(bent, Plane::through({0.5, 0, 0}, {1, 0, 0}));
  const glm::vec2 middle = glm::vec2(smallCamera().centerPixels());
  EXPECT_NEAR(glm::distance(graph.rayPath(middle).back(), glm::vec3(0, 0, -2)), 0, 1e-6);
  // z is the pinhole's on the ray that does not turn.
  EXPECT_TRUE(graph.unproject({middle.x, middle.y, 11.9f}));
  EXPECT_FALSE(graph.unproject({middle.x, middle.y, 12.1f}));
  EXPECT_TRUE(graph.project({0, 0, -1.9f}));
  EXPECT_FALSE(graph.project({0, 0, -2.1f}));
  EXPECT_TRUE(graph.project({0.45f, 0, -1}));
  EXPECT_FALSE(graph.project({0.55f, 0, -1}));
  EXPECT_TRUE(graph.project({0.55f, 0, 1})) << "limits of a frustum are not those of its parent";
  Numbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const glm::vec2 pixel(numbers.between(0, 90), numbers.between(0, 60));
    const RayPath path = graph.rayPath(pixel);
    const auto end = graph.project(path.back());
    ASSERT_TRUE(end) << pixel.x << " " << pixel.y;
    EXPECT_LT(glm::distance(glm::vec2(end->u, end->v), pixel), 0.01f);
  }
}

// A ray that begins beyond a limit of its frustum ends where it begins.
TEST(GraphCamera, limitsMayCutAwayWholeRays) {
  GraphCamera graph(smallCamera());
  const int bent = graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {0, 0, 5}), "bent");
  graph.limit(bent, Plane::through({0.1, 0, 0}, {1, 0, 0}));
  const auto onPlane = graph.project({0.2f, 0, 0.001f});
  ASSERT_TRUE(onPlane);
  const RayPath path = graph.rayPath({onPlane->u, onPlane->v});
  EXPECT_NEAR(path.back().z, 0, 1e-5);
  EXPECT_FALSE(graph.project({0.25f, 0, -1}));
}

// What a child sees beyond its plane is its own affair.
TEST(GraphCamera, limitsDoNotEndRaysThatGoOnToAChild) {
  GraphCamera graph(smallCamera());
  const int bent = graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {0, 0, 5}), "bent");
  graph.limit(bent, Plane::through({0, 0, -0.5}, {0, 0, -1}));
  graph.bend(bent, turnAt({0, 0, -1}, {0, 0, -1}, {0, 0, 4}), "further");
  EXPECT_TRUE(graph.project({0, 0, -0.8f}));
  EXPECT_TRUE(graph.project({0, 0, -5}));
}

TEST(GraphCamera, refusesWhatCannotBe) {
  const auto bending = [](const GraphCamera::Bend& turn, const GraphCamera::Part& part = {}) {
    return messageOf([&] { GraphCamera(smallCamera()).bend(0, turn, "corner", part); });
  };
  EXPECT_THAT(bending(turnAt({0, 0, 0}, {0, 0, -1}, {0, 0, -1})), HasSubstr("viewpoint does not lie before"));
  EXPECT_THAT(bending(turnAt({0, 0, 20}, {0, 0, -1}, {0, 0, 30})), HasSubstr("not every ray")) << "behind the root";
  EXPECT_THAT(bending(turnAt({0, 0, 0}, {1, 0, 0}, {-1, 0, 0})), HasSubstr("not every ray")) << "edge on";
  EXPECT_THAT(bending(turnAt({0, 0, 0}, {0, 0, 1}, {0, 0, -5})), HasSubstr("not every ray")) << "from behind";
  EXPECT_THAT(bending(turnAt({0, 0, -2000}, {0, 0, -1}, {0, 0, 5})), HasSubstr("not every ray")) << "beyond zFar";
  EXPECT_THAT(bending({{{0, 0, 2}, 0}, {0, 0, 5}}), HasSubstr("not finite, or the normal has no length"));
  EXPECT_THAT(bending({{{0, 0, -1}, NAN}, {0, 0, 5}}), HasSubstr("not finite"));
  const GraphCamera::Bend turn = turnAt({0, 0, 0}, {0, 0, -1}, {1, 0, 5});
  EXPECT_THAT(bending(turn, {{0, 0}, {10, 0}, {10, 10}, {4, 2}}), HasSubstr("not convex"));
  EXPECT_THAT(bending(turn, {{0, 0}, {0, 10}, {10, 10}, {10, 0}}), HasSubstr("not convex")) << "the wrong way round";
  EXPECT_THAT(bending(turn, {{0, 0}, {100, 0}, {100, 10}}), HasSubstr("not within that of \"root\""));
  EXPECT_THAT(bending(turn, {{0, 0}, {10, 0}}), HasSubstr("empty"));
  EXPECT_THAT(bending(turn, {{0, 0}, {NAN, 0}, {10, 10}}), HasSubstr("frustum \"corner\""));
  EXPECT_THAT(messageOf([&] {
                GraphCamera graph(smallCamera());
                graph.bend(0, turn, "one", {{0, 0}, {50, 0}, {50, 60}, {0, 60}});
                graph.bend(0, turn, "two", {{40, 0}, {90, 0}, {90, 60}, {40, 60}});
              }),
              HasSubstr("takes rays that \"one\" has"));
  EXPECT_THAT(messageOf([&] {
                GraphCamera graph(smallCamera());
                graph.bend(graph.bend(0, turn, "first"), turnAt({0, 0, 1}, {0, 0, -1}, {1, 0, 5}), "second");
              }),
              HasSubstr("not every ray of \"first\""))
      << "planes out of order";
  EXPECT_THAT(messageOf([&] {
                GraphCamera graph(smallCamera());
                graph.split(0, turn, turnAt({0, 0, -1}, {0, 0, -1}, {0, 0, 5}), "one", "two");
              }),
              HasSubstr("parallel"));
  EXPECT_THAT(messageOf([&] {
                GraphCamera graph(smallCamera());
                graph.split(0, turnAt({9, 0, 0}, {-0.3, 0, -1}, {0, 0, 7}), turnAt({9, 0, 0}, {0.3, 0, -1}, {0, 0, 7}),
                            "one", "two");
              }),
              HasSubstr("out of the sight"));
  EXPECT_THAT(messageOf([&] {
                GraphCamera graph(smallCamera());
                for (int i = 0; i < 100; ++i) {
                  graph.bend(i, turnAt({0, 0, 9 - 0.1 * i}, {0, 0, -1}, {0, 0, 10}), "turn");
                }
              }),
              HasSubstr("turn more than 64 times"));
}

TEST(GraphCameraDeath, refusesFrustaThatAreNone) {
  GraphCamera graph(smallCamera());
  const GraphCamera::Bend turn = turnAt({0, 0, 0}, {0, 0, -1}, {1, 0, 5});
  EXPECT_DEATH(graph.bend(1, turn, "bent"), "no such frustum");
  EXPECT_DEATH(graph.split(-1, turn, turn, "one", "other"), "no such frustum");
  EXPECT_DEATH(graph.merge(0, 1, turn, "merged"), "no such frustum");
  EXPECT_DEATH(graph.limit(7, turn.plane), "no such frustum");
}

TEST(GraphCamera, aFailedSplitLeavesItAsItWas) {
  GraphCamera graph(smallCamera());
  EXPECT_THROW(graph.split(0, turnAt({0, 0, 0.5}, {-0.3, 0, -1}, {1.5, 0, 7}),
                           turnAt({0, 0, 0.5}, {0.3, 0, -1}, {-1.5, 0, -7}), "left", "right"),
               InputError);
  EXPECT_EQ(graph.frusta().size(), 1u);
  EXPECT_TRUE(graph.frusta()[0].children.empty());
}

TEST(GraphCamera, cutsParts) {
  const auto [right, left] = GraphCamera::cut({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {1, 0}, {1, -1});
  EXPECT_THAT(right, testing::SizeIs(4));
  for (const glm::dvec2& corner : right) {
    EXPECT_GE(corner.x, 1);
  }
  for (const glm::dvec2& corner : left) {
    EXPECT_LE(corner.x, 1);
  }
  EXPECT_TRUE(GraphCamera::cut({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0, 0}, {0, -1}).second.empty());
}

}  // namespace
}  // namespace ocelli
