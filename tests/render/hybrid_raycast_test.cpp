#include "oc_core/render/hybrid_raycast.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/render/raycast.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

/// Every ray path against every triangle, in order.
template <class C>
FragmentImage bruteForce(const C& camera, const Mesh& mesh) {
  const RayPathTable paths(camera);
  const PinholeCamera& reference = referenceOf(camera);
  FragmentImage image(camera.width(), camera.height());
  for (size_t pixel = 0; pixel < image.size(); ++pixel) {
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const auto meeting = paths.meet(
          pixel, {reference.cameraFromWorld(mesh.positions[t.x]), reference.cameraFromWorld(mesh.positions[t.y]),
                  reference.cameraFromWorld(mesh.positions[t.z])});
      if (meeting && (!image[pixel].covered() || meeting->z < image[pixel].t)) {
        image[pixel] = {meeting->z, static_cast<uint32_t>(i), meeting->b1, meeting->b2};
      }
    }
  }
  return image;
}

TEST(HybridRaycast, isTheImageOfEveryRayAgainstEveryTriangle) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Mesh mesh = test::randomTriangles(seed * 25, seed);
    test::forEachSmallCamera([&](const char* name, const auto& camera) {
      EXPECT_TRUE(test::sameBytes(hybridRaycast(camera, mesh), bruteForce(camera, mesh))) << name << " " << seed;
    });
  }
}

// Embree is a peer that shares no code: the same triangle but for rays that pass an edge within rounding.
TEST(HybridRaycast, agreesWithEmbree) {
  const Mesh mesh = test::ballBeforePlane();
  const RayScene scene(mesh);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    const FragmentImage hybrid = hybridRaycast(camera, mesh);
    const FragmentImage cast = raycast(camera, mesh, scene);
    size_t different = 0;
    for (size_t i = 0; i < cast.size(); ++i) {
      different += hybrid[i].covered() != cast[i].covered();
      if (hybrid[i].covered() && cast[i].covered() && hybrid[i].triangle == cast[i].triangle) {
        // World coordinates of some units, met at up to 80 degrees.
        EXPECT_NEAR(hybrid[i].t, cast[i].t, 1e-4f) << name;
        EXPECT_LT(glm::distance(positionOf(hybrid[i], mesh), positionOf(cast[i], mesh)), 1e-4f) << name;
      }
    }
    EXPECT_LE(different, 2u) << name;
  });
}

// A fan of triangles, one by one: a ray meets one of them, or two where it meets the edge they share, never none.
TEST(HybridRaycast, noRaySlipsBetweenNeighbours) {
  Mesh mesh;
  mesh.positions.emplace_back(0.013f, -0.007f, 0.2f);
  constexpr uint32_t kRim = 40;
  for (uint32_t i = 0; i < kRim; ++i) {
    const float angle = 2 * static_cast<float>(kPi) * static_cast<float>(i) / kRim;
    mesh.positions.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0.5f * std::sin(3 * angle));
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % kRim);
  }
  const FragmentImage image = hybridRaycast(smallCamera(), mesh);
  for (const Fragment& f : image) {
    ASSERT_TRUE(f.covered());
  }
}

TEST(HybridRaycast, lowerTriangleWinsATie) {
  Mesh mesh = test::wall(0);
  test::addWall(mesh, 0, 3);  // the same again
  for (const Fragment& f : hybridRaycast(smallCamera(), mesh)) {
    ASSERT_LT(f.triangle, 2u);
  }
}

TEST(RayPathTable, meetsNothingBeforeOrBehindAPath) {
  View view;
  view.zNear = 9;
  view.zFar = 11;
  const PinholeCamera camera(view, kWidth, kHeight);
  const RayPathTable paths(camera);
  const size_t middle = static_cast<size_t>(kHeight / 2) * kWidth + kWidth / 2;
  const auto wallAt = [](float z) { return std::array{glm::vec3(-9, -9, z), glm::vec3(9, -9, z), glm::vec3(0, 9, z)}; };
  EXPECT_FALSE(paths.meet(middle, wallAt(8.99f)));
  EXPECT_TRUE(paths.meet(middle, wallAt(9.01f)));
  EXPECT_TRUE(paths.meet(middle, wallAt(10.99f)));
  EXPECT_FALSE(paths.meet(middle, wallAt(11.01f)));
  // Edge on, and without an area.
  EXPECT_FALSE(paths.meet(middle, {glm::vec3(0, 0, 9), glm::vec3(0, 0, 11), glm::vec3(0, 0, 10)}));
}

TEST(HybridRaycast, badInputDoesNoHarm) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = test::wall(0, 1);
  mesh.positions.insert(mesh.positions.end(), {{kNan, 0, 0}, {0, kNan, 0}, {3e38f, 3e38f, -3e38f}, {0, -1, 30}});
  mesh.colors.clear();
  mesh.triangles.emplace_back(0, 1, 4);
  mesh.triangles.emplace_back(5, 1, 2);
  mesh.triangles.emplace_back(0, 0, 0);
  mesh.triangles.emplace_back(0, 1, 6);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    EXPECT_TRUE(test::sameBytes(hybridRaycast(camera, Mesh{}), FragmentImage(kWidth, kHeight))) << name;
    for (const Fragment& f : hybridRaycast(camera, mesh)) {
      ASSERT_TRUE(!f.covered() || (f.t > 0.009f && f.t < 1001 && f.triangle != 2 && f.triangle != 3)) << name;
    }
  });
}

// A floor from far before the eye to far behind it (see rasterize_test.cpp): depth f / (v - h/2).
TEST(HybridRaycast, seesAFloorThatPassesUnderTheEye) {
  const PinholeCamera camera = smallCamera();
  Mesh mesh;
  test::addQuad(mesh, {-100, -1, 30}, {100, -1, 30}, {100, -1, -5}, {-100, -1, -5});
  const FragmentImage image = hybridRaycast(camera, mesh);
  for (int y = 0; y < kHeight; ++y) {
    const double inverseZ = (y + 0.5 - kHeight / 2.0) / static_cast<double>(camera.focalPixels());
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(image(x, y).covered(), inverseZ > 1 / 15.0) << x << " " << y;
      if (image(x, y).covered()) {
        EXPECT_NEAR(1 / image(x, y).t, inverseZ, 2e-6 * inverseZ);
      }
    }
  }
}

TEST(HybridRaycast, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::randomTriangles(300, 9);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    setThreadCount(1);
    const FragmentImage one = hybridRaycast(camera, mesh);
    for (const int threads : {2, 8}) {
      setThreadCount(threads);
      EXPECT_TRUE(test::sameBytes(hybridRaycast(camera, mesh), one)) << name << " " << threads;
    }
    setThreadCount(0);
  });
}

}  // namespace
}  // namespace ocelli
