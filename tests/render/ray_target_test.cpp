#include "oc_core/render/ray_target.h"

#include <gtest/gtest.h>

#include <random>

#include "oc_core/camera/panorama_camera.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/triangle_tree.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

/// A ball that no mesh holds.
class Ball final : public RayTarget {
 public:
  std::optional<Hit> hit(const RayPath& ray) const override {
    for (size_t i = 0; i + 1 < ray.size(); ++i) {
      const glm::vec3 way = ray[i + 1] - ray[i];
      const float a = glm::dot(way, way);
      const float b = glm::dot(ray[i], way);
      const float root = b * b - a * (glm::dot(ray[i], ray[i]) - 1);
      const float share = root >= 0 ? (-b - std::sqrt(root)) / a : -1;
      if (share >= 0 && share <= 1) {
        const RayPath::Position position{i, share};
        return Hit{ray.tAt(position), ray.pointAt(position), {1, 0, 0}, 0};
      }
    }
    return std::nullopt;
  }
  Box bounds() const override { return {glm::vec3(-1), glm::vec3(1)}; }
};

TEST(RayTarget, anyTargetIsSeenByAnyCamera) {
  const PinholeCamera camera = test::smallCamera();
  const HitImage seen = castRays(camera, Ball());
  size_t covered = 0;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (seen(x, y)) {
        ++covered;
        const std::optional<ImagePoint> q = camera.project(seen(x, y)->position);
        ASSERT_TRUE(q);
        // World coordinates of 10 units round by 1e-6, which a focal length of 300 pixels at depth 9 makes 4e-5 pixels;
        // roots of the ball's quadratic lose some digits more at its rim.
        EXPECT_NEAR(q->u, static_cast<float>(x) + 0.5f, 1e-3f);
        EXPECT_NEAR(q->t, seen(x, y)->t, 1e-5f) << "t is that of the camera, but for ten such roundings";
      }
    }
  }
  // The default view just holds the unit sphere: a disc that is as high as the image.
  EXPECT_NEAR(static_cast<double>(covered), 3.14159 * 30 * 30, 60);
}

TEST(RayScene, hitsSayWhatTheFragmentsSay) {
  const Mesh mesh = test::boxBeforeWall();
  const RayScene scene(mesh);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    const FragmentImage fragments = raycast(camera, mesh, scene);
    const HitImage hits = castRays(camera, scene);
    for (size_t i = 0; i < hits.size(); ++i) {
      if (fragments[i].covered()) {
        ASSERT_TRUE(hits[i]) << name;
        EXPECT_EQ(hits[i]->element, fragments[i].triangle);
        EXPECT_EQ(hits[i]->position, positionOf(fragments[i], mesh));
        EXPECT_EQ(hits[i]->color, colorOf(fragments[i], mesh));
        EXPECT_NEAR(hits[i]->t, fragments[i].t, 2e-5f) << name;
      }
    }
  });
}

TEST(RayScene, raysThatAreNotFiniteHitNothing) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  EXPECT_FALSE(scene.hit({{0, 0, std::numeric_limits<float>::quiet_NaN()}, {0, 0, -1}}));
  EXPECT_FALSE(scene.hit(RayPath{}));
}

float randomShare(std::mt19937& random) {
  return static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
}

glm::vec3 randomPoint(std::mt19937& random) {
  const float x = randomShare(random);
  const float y = randomShare(random);
  return glm::vec3(x, y, randomShare(random)) * 4.0f - 2.0f;
}

// The acceleration structure of the toolkit (Embree's, where it is built with it) against the tree, and the tree
// against all triangles one by one.
TEST(TriangleTree, meetsWhatTheAccelerationStructureMeets) {
  std::mt19937 random(11);
  const Mesh mesh = test::randomTriangles(400, 5);
  const RayScene scene(mesh);
  const TriangleTree tree(mesh);
  size_t met = 0;
  size_t different = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 from = randomPoint(random);
    const glm::vec3 to = randomPoint(random);
    const auto meeting = tree.meet(from, to - from, 1);
    const Fragment fragment = scene.intersect({from, to});
    met += meeting.has_value();
    different += meeting.has_value() != fragment.covered() || (meeting && meeting->triangle != fragment.triangle);
    if (meeting && meeting->triangle == fragment.triangle) {
      // Embree works in single precision: 1e-7 of lengths of 4, divided by what triangles seen nearly edge on cover.
      EXPECT_NEAR(meeting->b1, fragment.b1, 1e-3f);
      EXPECT_NEAR(meeting->b2, fragment.b2, 1e-3f);
    }
  }
  EXPECT_GT(met, 1000u);
  EXPECT_LE(different, 2u) << "rays that graze an edge";
}

TEST(TriangleTree, meetsTheFirstOfAllTriangles) {
  std::mt19937 random(12);
  const Mesh mesh = test::randomTriangles(60, 7);
  const TriangleTree tree(mesh);
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 from = randomPoint(random);
    const glm::vec3 way = randomPoint(random) - from;
    std::optional<TriangleTree::Meeting> first;
    for (uint32_t k = 0; k < mesh.triangles.size(); ++k) {
      Mesh one = mesh;
      one.triangles = {mesh.triangles[k]};
      const auto meeting = TriangleTree(one).meet(from, way, 1);
      if (meeting && (!first || meeting->share < first->share)) {
        first = TriangleTree::Meeting{k, meeting->share, meeting->b1, meeting->b2};
      }
    }
    const auto meeting = tree.meet(from, way, 1);
    ASSERT_EQ(meeting.has_value(), first.has_value());
    if (meeting) {
      EXPECT_EQ(meeting->triangle, first->triangle);
      EXPECT_EQ(meeting->share, first->share);
    }
  }
}

TEST(TriangleTree, nearestIsTheNearestOfAllTriangles) {
  std::mt19937 random(13);
  const Mesh mesh = test::randomTriangles(60, 9);
  const TriangleTree tree(mesh);
  const RayScene scene(mesh);
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 point = randomPoint(random);
    const float reach = randomShare(random);
    const auto found = tree.nearest(point, reach);
    const auto expected = scene.closestSurface(point, reach);
    ASSERT_EQ(found.has_value(), expected.has_value());
    if (found) {
      EXPECT_EQ(found->triangle, expected->triangle);
      EXPECT_LT(glm::distance(found->position, expected->position), 1e-5f);
    }
  }
}

// Rays along the axes, in the planes of the faces of boxes and through shared edges.
TEST(TriangleTree, raysAlongTheAxesFindAGridOfTriangles) {
  Mesh mesh;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto at = [&](int i, int j) { return glm::vec3(static_cast<float>(x + i), static_cast<float>(y + j), 0); };
      test::addQuad(mesh, at(0, 0), at(1, 0), at(1, 1), at(0, 1));
    }
  }
  const TriangleTree tree(mesh);
  for (int y = 0; y <= 16; ++y) {
    for (int x = 0; x <= 16; ++x) {
      const glm::vec3 from(static_cast<float>(x) / 2, static_cast<float>(y) / 2, 3);
      const auto meeting = tree.meet(from, {0, 0, -6}, 1);
      ASSERT_TRUE(meeting) << x << " " << y;
      EXPECT_EQ(meeting->share, 0.5);
    }
  }
  EXPECT_FALSE(tree.meet({4, 4, 3}, {1, 0, 0}, 1));
  EXPECT_FALSE(TriangleTree(Mesh{}).meet({0, 0, 1}, {0, 0, -2}, 1));
}

}  // namespace
}  // namespace ocelli
