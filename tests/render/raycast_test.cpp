#include "oc_core/render/raycast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "oc_core/base/random.h"
#include "oc_core/worlds/solids.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

TEST(RayScene, firstTriangleAlongTheSegmentsIsHit) {
  Mesh mesh = test::wall(0, 1);  // triangles 0 and 1
  test::addWall(mesh, -1, 1);    // 2 and 3
  const RayScene scene(mesh);
  // Straight on, both walls: the nearer one.
  const Fragment near = scene.intersect({{0.5f, -0.5f, 3}, {0.5f, -0.5f, -3}});
  EXPECT_EQ(near.triangle, 0u);
  EXPECT_LT(glm::distance(positionOf(near, mesh), glm::vec3(0.5f, -0.5f, 0)), 1e-5f);
  // Around the first wall.
  const RayPath around{{0.5f, -0.5f, 3}, {2, 0, 1}, {2, 0, -0.5f}, {-0.5f, 0.5f, -1.5f}};
  const Fragment far = scene.intersect(around);
  ASSERT_TRUE(far.covered());
  EXPECT_GE(far.triangle, 2u);
  // Half way along the last segment.
  EXPECT_LT(glm::distance(positionOf(far, mesh), glm::vec3(0.75f, 0.25f, -1)), 1e-5f);
}

// Rays that bend just at the front of a box: it must not fall between their segments. 1e-3: rounding of its edges.
TEST(Raycast, surfacesWhereSegmentsMeetAreHit) {
  const Mesh mesh = test::boxBeforeWall();
  const float zNear = test::smallCamera().cameraFromWorld(mesh.positions.back()).z;
  const SpocCamera camera(test::smallCamera(), {{45, 30}, zNear, 10.9f, 0, 6});
  const FragmentImage image = raycast(camera, mesh, RayScene(mesh));
  const double half = static_cast<double>(test::kBoxHalf * test::smallCamera().focalPixels() / zNear);
  size_t front = 0;
  for (int y = 0; y < test::kHeight; ++y) {
    for (int x = 0; x < test::kWidth; ++x) {
      if (std::max(std::abs(x + 0.5 - 45), std::abs(y + 0.5 - 30)) < half - 1e-3) {
        ++front;
        EXPECT_NEAR(image(x, y).t, zNear, 1e-5f) << x << " " << y;
      }
    }
  }
  EXPECT_GT(front, 300u);
}

TEST(RayScene, linesMeetWhatTheirPathsHit) {
  const Mesh mesh = makeTorus(0.3f, 24);
  const RayScene rays(mesh);
  Random random(1);
  std::vector<SightLine> lines;
  for (int i = 0; i < 403; ++i) {  // not a multiple of any packet
    const auto point = [&] {
      return glm::vec3(random.inRange(-1.2f, 1.2f), random.inRange(-1.2f, 1.2f), random.inRange(-1.2f, 1.2f));
    };
    lines.push_back({point(), point()});
  }
  lines.push_back({{0, 0, 0}, {0, 0, std::nanf("")}});
  std::vector<float> shares(lines.size(), 7);
  rays.meet(lines, shares);
  std::vector<Fragment> fragments(lines.size(), {7, 7, 7, 7});
  rays.meet(lines, fragments);
  size_t met = 0;
  size_t sameTriangle = 0;
  for (size_t i = 0; i + 1 < lines.size(); ++i) {
    const Fragment expected = rays.intersect(RayPath{lines[i].from, lines[i].to});
    const float length = glm::distance(lines[i].from, lines[i].to);
    ASSERT_EQ(fragments[i].covered(), expected.covered()) << i;
    if (expected.covered()) {
      EXPECT_NEAR(shares[i] * length, expected.t, 1e-5f) << i;
      EXPECT_EQ(fragments[i].t, shares[i]) << i;
      EXPECT_LT(glm::distance(positionOf(fragments[i], mesh), positionOf(expected, mesh)), 1e-5f) << i;
      sameTriangle += fragments[i].triangle == expected.triangle ? 1 : 0;
      ++met;
    } else {
      EXPECT_TRUE(std::isinf(shares[i])) << i;
    }
  }
  EXPECT_TRUE(std::isinf(shares.back()));
  EXPECT_FALSE(fragments.back().covered());
  EXPECT_GT(met, 50u);
  EXPECT_GE(sameTriangle + 2, met) << "at an edge either is right";
}

TEST(RayScene, whatLiesBeyondTheLastPointIsNotHit) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  EXPECT_FALSE(scene.intersect({{0.5f, 0, 3}, {0.5f, 0, 0.01f}}).covered());
  EXPECT_TRUE(scene.intersect({{0.5f, 0, 3}, {0.5f, 0, -0.01f}}).covered());
  EXPECT_FALSE(scene.intersect({{0.5f, 0, 3}}).covered());
  EXPECT_FALSE(scene.intersect({}).covered());
}

// A square of half side 1 in the plane z = 0.
TEST(RayScene, surfaceIsNearWithinItsDistance) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  const auto expectDistance = [&](const glm::vec3& point, float distance) {
    EXPECT_TRUE(scene.hasSurfaceNear(point, distance + 1e-4f)) << distance;
    EXPECT_FALSE(scene.hasSurfaceNear(point, distance - 1e-4f)) << distance;
  };
  expectDistance({0.2f, 0.3f, 0.5f}, 0.5f);
  expectDistance({0.2f, -0.3f, -0.5f}, 0.5f);
  expectDistance({2, 0.3f, 0}, 1);
  expectDistance({4, 0.3f, 4}, 5);
  expectDistance({2, 3, 2}, 3);
  EXPECT_TRUE(scene.hasSurfaceNear({0.5f, 0.5f, 0}, 1e-5f));
}

// Against points all over the triangles, 1/40 of a side apart.
TEST(RayScene, surfaceIsNearWherePointsOfItAre) {
  const Mesh mesh = test::randomTriangles(30, 5);
  const RayScene scene(mesh);
  std::mt19937 random(3);
  const auto next = [&] { return static_cast<float>(random() >> 8) / static_cast<float>(1 << 23) - 1; };
  size_t near = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 point{next(), next(), next()};
    constexpr float kReach = 0.12f;
    float least = 1e9f;
    for (const glm::uvec3& t : mesh.triangles) {
      for (int b = 0; b <= 40; ++b) {
        for (int c = 0; b + c <= 40; ++c) {
          const glm::vec3 q = mesh.positions[t.x] * (static_cast<float>(40 - b - c) / 40) +
                              mesh.positions[t.y] * (static_cast<float>(b) / 40) +
                              mesh.positions[t.z] * (static_cast<float>(c) / 40);
          least = std::min(least, glm::distance(q, point));
        }
      }
    }
    const bool found = scene.hasSurfaceNear(point, kReach);
    near += found;
    if (least <= kReach) {
      EXPECT_TRUE(found);
    }
    // A side is at most sqrt(12) long, so a point of the surface is within 0.09 of one of the points.
    if (found) {
      EXPECT_LE(least, kReach + 0.09f);
    }
  }
  EXPECT_GT(near, 20u);
  EXPECT_LT(near, 180u);
}

TEST(RayScene, closestSurfaceIsTheNearestPointOfAllTriangles) {
  const Mesh mesh = test::randomTriangles(30, 5);
  const RayScene scene(mesh);
  const RayScene quick(mesh, RayScene::Quality::kLow);
  std::mt19937 random(3);
  const auto next = [&] { return static_cast<float>(random() >> 8) / static_cast<float>(1 << 23) - 1; };
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 point{next(), next(), next()};
    const auto closest = scene.closestSurface(point, 10);
    ASSERT_TRUE(closest);
    const float distance = glm::distance(closest->position, point);
    // Rounding of positions of about one.
    EXPECT_FALSE(scene.hasSurfaceNear(point, distance - 1e-5f));
    EXPECT_FALSE(scene.closestSurface(point, distance - 1e-5f));
    Mesh alone = mesh;
    alone.triangles = {mesh.triangles[closest->triangle]};
    EXPECT_TRUE(RayScene(alone).hasSurfaceNear(closest->position, 1e-5f));
    EXPECT_EQ(quick.closestSurface(point, 10)->triangle, closest->triangle);
  }
  EXPECT_FALSE(RayScene(Mesh{}).closestSurface({0, 0, 0}, 10));
}

// On the diagonal that both triangles of a wall share.
TEST(RayScene, closestSurfaceIsOfTheFirstOfTrianglesThatAreEquallyClose) {
  Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  EXPECT_EQ(scene.closestSurface({0, 0, 0}, 1)->triangle, 0u);
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  EXPECT_EQ(RayScene(mesh).closestSurface({0, 0, 0}, 1)->triangle, 0u);
}

TEST(RayScene, trianglesWithoutAnAreaAreNearToo) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(RayScene(mesh).hasSurfaceNear({1.5f, 0.1f, 0}, 0.2f));
  EXPECT_FALSE(RayScene(mesh).hasSurfaceNear({1.5f, 0.3f, 0}, 0.2f));
  EXPECT_FALSE(RayScene(Mesh{}).hasSurfaceNear({0, 0, 0}, 10));
}

// A finely made unit ball: the ray through the middle meets it at depth 9, and its silhouette is where the default view
// ends: sin = 1 / 10. Off the middle, by the law of sines, at depth z with x^2 + (10 - z)^2 = 1 on the ray x = t z.
TEST(Raycast, ballHasItsAnalyticDepth) {
  const PinholeCamera camera = test::smallCamera();
  const Mesh ball = makeSphere(512);
  const FragmentImage image = raycast(camera, ball, RayScene(ball));
  for (int y = 0; y < test::kHeight; ++y) {
    for (int x = 0; x < test::kWidth; ++x) {
      const double du = (x + 0.5 - test::kWidth / 2.0) / camera.focalPixels();
      const double dv = (y + 0.5 - test::kHeight / 2.0) / camera.focalPixels();
      const double t2 = du * du + dv * dv;
      // (1 + t2) z^2 - 20 z + 99 = 0
      const double inside = 100 - 99 * (1 + t2);
      if (inside > 0.05) {
        ASSERT_TRUE(image(x, y).covered()) << x << " " << y;
        // Facets of 2 pi / 512 lie up to 1 - cos(pi / 512) = 2e-5 below the ball, times two the other way around, over
        // the cosine of incidence.
        EXPECT_NEAR(image(x, y).t, (10 - std::sqrt(inside)) / (1 + t2), 6e-5 / std::sqrt(inside));
      } else if (inside < -0.05) {
        EXPECT_FALSE(image(x, y).covered()) << x << " " << y;
      }
    }
  }
}

// One ray at a time is the reference of the packets, for rays of different lengths, whole tiles and parts of them.
TEST(RayScene, packetsMeetWhatSingleRaysMeet) {
  const Mesh mesh = test::randomTriangles(60, 8);
  for (const auto quality : {RayScene::Quality::kLow, RayScene::Quality::kMedium}) {
    const RayScene scene(mesh, quality);
    test::forEachSmallCamera([&](const char* name, const auto& camera) {
      const FragmentImage packets =
          castRays(test::kWidth, test::kHeight, scene, [&](const glm::vec2& pixel) { return camera.rayPath(pixel); });
      size_t covered = 0;
      size_t different = 0;
      for (int y = 0; y < test::kHeight; ++y) {
        for (int x = 0; x < test::kWidth; ++x) {
          const Fragment single =
              scene.intersect(camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}));
          covered += single.covered();
          // Where two triangles share what is met, rounding may choose either.
          different += single.triangle != packets(x, y).triangle;
          if (single.triangle == packets(x, y).triangle) {
            EXPECT_NEAR(single.b1, packets(x, y).b1, 1e-4f) << name;
            EXPECT_NEAR(single.b2, packets(x, y).b2, 1e-4f) << name;
          }
        }
      }
      EXPECT_GT(covered, 1000u) << name;
      EXPECT_LE(different, 1u) << name;
    });
  }
}

TEST(RayScene, shortPathsAmongLongOnesMeetNothing) {
  const Mesh mesh = test::wall(0, 1);
  const RayScene scene(mesh);
  const std::vector<RayPath> paths{{},
                                   {{0.5f, 0, 3}},
                                   {{0.5f, 0, 3}, {0.5f, 0, 1}, {0.5f, 0, -1}},
                                   {{0.5f, 0, 3}, {0.5f, 0, 1}},
                                   {{0.25f, 0, 3}, {0.25f, 0, -1}}};
  std::vector<Fragment> met(paths.size(), Fragment{5, 5, 5, 5});
  scene.intersect(paths, met);
  for (size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(met[i].covered(), i == 2 || i == 4) << i;
  }
}

TEST(RayScene, badMeshesDoNoHarm) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const Mesh none;
  EXPECT_TRUE(
      test::sameBytes(raycast(test::smallCamera(), none, RayScene(none)), FragmentImage(test::kWidth, test::kHeight)));
  Mesh broken = test::wall(0, 1);
  broken.positions.emplace_back(kNan, 0, 0);
  broken.colors.clear();
  broken.triangles.emplace_back(0, 1, 4);
  broken.triangles.emplace_back(0, 0, 0);
  const RayScene scene(broken);
  EXPECT_EQ(scene.intersect({{0.5f, -0.5f, 3}, {0.5f, -0.5f, -3}}).triangle, 0u);
  // Segments that are no rays are skipped, one by one and in packets.
  const std::vector<RayPath> paths{{{kNan, 0, 3}, {0, 0, -3}},
                                   {{0.5f, -0.5f, 3}, {0.5f, -0.5f, 3e38f}, {0.5f, -0.5f, -3e38f}},
                                   {{0.5f, -0.5f, 3}, {kNan, 0, 0}, {0.5f, -0.5f, 3}, {0.5f, -0.5f, -3}}};
  std::vector<Fragment> met(paths.size());
  scene.intersect(paths, met);
  for (size_t i = 0; i < paths.size(); ++i) {
    EXPECT_EQ(scene.intersect(paths[i]).covered(), i == 2);
    EXPECT_EQ(met[i].covered(), i == 2);
  }
}

TEST(Raycast, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::randomTriangles(100, 9);
  const RayScene scene(mesh);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    setThreadCount(1);
    const FragmentImage one = raycast(camera, mesh, scene);
    for (const int threads : {2, 8}) {
      setThreadCount(threads);
      EXPECT_TRUE(test::sameBytes(raycast(camera, mesh, scene), one)) << name << " " << threads;
    }
    setThreadCount(0);
  });
}

}  // namespace
}  // namespace ocelli
