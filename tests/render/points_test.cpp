#include "oc_core/render/points.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/render/raycast.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

// By the definition of a splat: the sample of a fragment is a point of its triangle whose image point is half a splat
// away from the centre of the pixel at most.
TEST(Points, everyFragmentIsASampleNextToItsPixel) {
  const Mesh mesh = test::randomTriangles(40, 3);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    for (const float splat : {1.0f, 3.0f}) {
      PointOptions options;
      options.splatPixels = splat;
      const FragmentImage image = renderPoints(camera, mesh, options);
      size_t covered = 0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Fragment& f = image(x, y);
          if (!f.covered()) {
            continue;
          }
          ++covered;
          ASSERT_TRUE(f.b1 >= 0 && f.b2 >= 0 && f.b1 + f.b2 <= 1.00001f);
          const auto q = camera.project(positionOf(f, mesh));
          ASSERT_TRUE(q) << name;
          EXPECT_LE(std::abs(q->u - static_cast<float>(x) - 0.5f), splat / 2 + 1e-3f) << name;
          EXPECT_LE(std::abs(q->v - static_cast<float>(y) - 0.5f), splat / 2 + 1e-3f) << name;
          EXPECT_FLOAT_EQ(q->t, f.t);
        }
      }
      EXPECT_GT(covered, 1000u) << name;
    }
  });
}

// A surface that fills the image leaves no hole, whatever its triangles are like. Around a pole the camera sees a disc
// of nothing, of radius d(z), and what a ring of 1/64 pixel around the pole becomes has gaps.
TEST(Points, surfacesHaveNoHoles) {
  Mesh plane;
  for (const float x : {-3.0f, -0.04f, 0.01f, 0.02f, 1.0f, 3.0f}) {
    const auto first = static_cast<uint32_t>(plane.positions.size());
    plane.positions.emplace_back(x, -3, -0.4f);
    plane.positions.emplace_back(x, 3, 0.5f);
    if (first > 0) {
      plane.triangles.emplace_back(first - 2, first, first - 1);
      plane.triangles.emplace_back(first - 1, first, first + 1);
    }
  }
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    const FragmentImage image = renderPoints(camera, plane);
    size_t holes = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool nearPole = glm::distance(glm::dvec2(x + 0.5, y + 0.5), glm::dvec2(40.3, 28.7)) < 6 + 1;
        holes += !image(x, y).covered() && !nearPole;
      }
    }
    EXPECT_EQ(holes, 0u) << name;
  });
}

// Covering is what the spacing is for: splats half as far apart change nothing about what is covered inside.
TEST(Points, coverWhatTheRaysMeet) {
  const Mesh mesh = test::ballBeforePlane();
  const RayScene scene(mesh);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    const FragmentImage cast = raycast(camera, mesh, scene);
    const FragmentImage points = renderPoints(camera, mesh);
    size_t farther = 0;
    size_t missing = 0;
    for (int y = 1; y + 1 < kHeight; ++y) {
      for (int x = 1; x + 1 < kWidth; ++x) {
        if (!cast(x, y).covered()) {
          continue;
        }
        float farthest = 0;
        for (int v = y - 1; v <= y + 1; ++v) {
          for (int u = x - 1; u <= x + 1; ++u) {
            farthest = std::max(farthest, cast(u, v).t);
          }
        }
        missing += !points(x, y).covered();
        // A surface seen through another would be a hole in the nearer one.
        farther += points(x, y).covered() && points(x, y).t > farthest + 1e-4f;
      }
    }
    // In the ring around the pole (above): 2 pi 6 pixels long.
    EXPECT_LE(missing, 40u) << name;
    EXPECT_LE(farther, 2u) << name;
  });
}

TEST(Points, smallTrianglesAreTheirVertices) {
  Mesh mesh;
  const PinholeCamera camera = smallCamera();
  const float footprint = 10 / camera.focalPixels();
  mesh.positions = {{0, 0, 0}, {0.3f * footprint, 0, 0}, {0, 0.3f * footprint, 0}};
  mesh.triangles = {{0, 1, 2}};
  const PointSampler<PinholeCamera> sampler(camera, mesh, {});
  int samples = 0;
  sampler.sample(0, [&](const ImagePoint&, float b1, float b2) {
    EXPECT_EQ(b1 + b2, samples == 0 ? 0.0f : 1.0f);
    ++samples;
  });
  EXPECT_EQ(samples, 3);
}

// n samples for each pixel of area, not for each of its triangles: a wall of 60 x 60 pixels, halved until its edges are
// 0.866 pixels, has triangles with legs between 0.61 / sqrt(2) and 0.61 pixels.
TEST(Points, samplesAreAsDenseAsThePixels) {
  Mesh mesh = test::wall(0, 0.99f);
  const PinholeCamera camera = smallCamera();
  const PointSampler<PinholeCamera> sampler(camera, mesh, {});
  size_t samples = 0;
  for (uint32_t triangle = 0; triangle < 2; ++triangle) {
    sampler.sample(triangle, [&](const ImagePoint&, float, float) { ++samples; });
  }
  const double side = 2 * 0.99 * static_cast<double>(camera.focalPixels()) / 10;
  // Inner samples are the middle of an edge of two triangles, and come twice.
  EXPECT_GT(static_cast<double>(samples), side * side / 0.75);
  EXPECT_LT(static_cast<double>(samples), 2.2 * side * side / (0.43 * 0.43));
}

TEST(Points, badInputDoesNoHarm) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = test::wall(0, 1);
  mesh.positions.insert(mesh.positions.end(), {{kNan, 0, 0}, {0, kNan, 0}, {3e38f, 3e38f, -3e38f}, {0, -1, 30}});
  mesh.colors.clear();
  mesh.triangles.emplace_back(0, 1, 4);
  mesh.triangles.emplace_back(5, 1, 2);
  mesh.triangles.emplace_back(0, 0, 0);
  mesh.triangles.emplace_back(0, 1, 6);
  mesh.triangles.emplace_back(0, 1, 7);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    EXPECT_TRUE(test::sameBytes(renderPoints(camera, Mesh{}), FragmentImage(kWidth, kHeight))) << name;
    for (const Fragment& f : renderPoints(camera, mesh)) {
      ASSERT_TRUE(!f.covered() || (f.t > 0.009f && f.t < 1001)) << name;
    }
  });
}

TEST(Points, trianglesWithoutAnAreaEnd) {
  Mesh mesh;  // all on a line, at the spacings that a folded field once made it go round in circles
  mesh.positions = {{-1, 0, -0.5f}, {-0.5f, 0, 0}, {0, 0, 0.5f}, {0.5f, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 0}, {2, 3, 0}};
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    for (const Fragment& f : renderPoints(camera, mesh)) {
      ASSERT_TRUE(!f.covered() || f.t > 8) << name;
    }
  });
}

TEST(Points, seeAFloorThatPassesUnderTheEye) {
  const PinholeCamera camera = smallCamera();
  Mesh mesh;
  test::addQuad(mesh, {-100, -1, 30}, {100, -1, 30}, {100, -1, -5}, {-100, -1, -5});
  const FragmentImage image = renderPoints(camera, mesh);
  for (int y = 0; y < kHeight; ++y) {
    const double inverseZ = (y + 0.5 - kHeight / 2.0) / static_cast<double>(camera.focalPixels());
    const double halfPixel = 0.5 / static_cast<double>(camera.focalPixels()) + 1e-6;
    for (int x = 0; x < kWidth; ++x) {
      if (std::abs(inverseZ - 1 / 15.0) > halfPixel) {
        ASSERT_EQ(image(x, y).covered(), inverseZ > 1 / 15.0) << x << " " << y;
      }
      if (image(x, y).covered()) {
        EXPECT_NEAR(1 / image(x, y).t, inverseZ, halfPixel);
      }
    }
  }
}

TEST(Points, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::randomTriangles(300, 9);
  test::forEachSmallCamera([&](const char* name, const auto& camera) {
    setThreadCount(1);
    const FragmentImage one = renderPoints(camera, mesh);
    for (const int threads : {2, 8}) {
      setThreadCount(threads);
      EXPECT_TRUE(test::sameBytes(renderPoints(camera, mesh), one)) << name << " " << threads;
    }
    setThreadCount(0);
  });
}

}  // namespace
}  // namespace ocelli
