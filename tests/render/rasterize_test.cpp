#include "oc_core/render/rasterize.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/render/raycast.h"
#include "tests/ocri/test_scenes.h"
#include "tests/render/render_checks.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kSnapPixels;
using test::kWidth;
using test::mayDiffer;
using test::smallCamera;
using test::TriangleImage;

/// Calls check(x, y, centre) for each pixel.
template <class Check>
void forPixels(const Check& check) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      check(x, y, glm::dvec2(x + 0.5, y + 0.5));
    }
  }
}

size_t coveredPixels(const FragmentImage& image) {
  return static_cast<size_t>(std::count_if(image.begin(), image.end(), [](const Fragment& f) { return f.covered(); }));
}

// The plane z = -s y seen from (0, 0, 10): the ray of (u, v) meets it at depth 10 / (1 + s (v - h/2) / f), so 1/z has a
// slope of s / (10 f) for a pixel, which is what snapping by a part of a pixel costs.
TEST(Rasterize, tiltedPlaneHasItsAnalyticDepth) {
  const PinholeCamera camera = smallCamera();
  const double f = camera.focalPixels();
  for (const float s : {0.0f, 0.5f, -3.0f, 9.0f}) {
    const Mesh mesh = test::tiltedPlane(s, 60);
    const FragmentImage image = rasterize(camera, mesh);
    forPixels([&](int x, int y, const glm::dvec2& centre) {
      const Fragment& fragment = image(x, y);
      ASSERT_TRUE(fragment.covered()) << x << " " << y;
      const double inverseZ = (1 + s * (centre.y - kHeight / 2.0) / f) / 10;
      EXPECT_NEAR(1 / fragment.t, inverseZ, std::abs(s) / (10 * f) * kSnapPixels + 2e-6 * inverseZ + 1e-8);
    });
  }
}

TEST(Rasterize, weightsPutTheFragmentOntoTheRayOfItsPixel) {
  const PinholeCamera camera = smallCamera();
  const Mesh mesh = test::ballBeforePlane();
  const FragmentImage image = rasterize(camera, mesh);
  forPixels([&](int x, int y, const glm::dvec2& centre) {
    ASSERT_TRUE(image(x, y).covered());
    const std::optional<ImagePoint> q = camera.project(positionOf(image(x, y), mesh));
    ASSERT_TRUE(q);
    // The snap, and the rounding of world coordinates of a few units.
    EXPECT_NEAR(q->u, centre.x, kSnapPixels + 1e-3);
    EXPECT_NEAR(q->v, centre.y, kSnapPixels + 1e-3);
    // Rounding of weights on a plane whose corners lie 6 units apart.
    EXPECT_NEAR(q->t, image(x, y).t, 1e-4);
  });
}

// A floor at y = -1 from far before the eye to far behind it: depth f / (v - h/2) below the horizon, down to its end at
// depth 15.
TEST(Rasterize, clipsAFloorThatPassesUnderTheEye) {
  const PinholeCamera camera = smallCamera();
  const double f = camera.focalPixels();
  Mesh mesh;
  test::addQuad(mesh, {-100, -1, 30}, {100, -1, 30}, {100, -1, -5}, {-100, -1, -5});
  const FragmentImage image = rasterize(camera, mesh);
  forPixels([&](int x, int y, const glm::dvec2& centre) {
    const double inverseZ = (centre.y - kHeight / 2.0) / f;
    if (std::abs(1 / 15.0 - inverseZ) * f > 0.01) {  // not at its far end
      ASSERT_EQ(image(x, y).covered(), inverseZ > 1 / 15.0) << x << " " << y;
    }
    if (image(x, y).covered()) {
      EXPECT_NEAR(1 / image(x, y).t, inverseZ, kSnapPixels / f + 2e-6 * inverseZ);
      // Weights, on triangles 200 units across.
      EXPECT_NEAR(positionOf(image(x, y), mesh).y, -1, 1e-4);
    }
  });
}

TEST(Rasterize, whatIsOutOfTheFrustumLeavesNothing) {
  const PinholeCamera camera = smallCamera();
  for (const glm::vec3 offset :
       {glm::vec3(0, 0, 20), glm::vec3(0, 0, 9.995f), glm::vec3(0, 0, -1500), glm::vec3(40, 0, 0), glm::vec3(0, -40, 0),
        glm::vec3(-1e6f, 1e6f, 0), glm::vec3(0, 0, 1e30f)}) {
    Mesh mesh = test::wall(0, 1);
    for (glm::vec3& p : mesh.positions) {
      p += offset;
    }
    EXPECT_EQ(coveredPixels(rasterize(camera, mesh)), 0u) << offset.x << " " << offset.y << " " << offset.z;
  }
}

TEST(Rasterize, wallOfAnySizeFillsTheImageAtItsDepth) {
  for (const float half : {3.0f, 30.0f, 300.0f, 3e4f, 1e6f}) {
    const FragmentImage image = rasterize(smallCamera(), test::wall(-1, half));
    forPixels([&](int x, int y, const glm::dvec2&) {
      ASSERT_TRUE(image(x, y).covered()) << half;
      EXPECT_NEAR(image(x, y).t, 11, 1e-4) << half;
    });
  }
}

TEST(Rasterize, absurdCoordinatesDoNoHarm) {
  for (const float huge : {1e12f, 1e20f, 1e30f, 3e38f}) {
    Mesh mesh = test::randomTriangles(300, 5);
    for (size_t i = 0; i < mesh.positions.size(); i += 2) {
      mesh.positions[i] *= huge;
    }
    test::addWall(mesh, -0.5f, huge);
    View tilted;
    tilted.eye = {5, 6, 7};
    for (const PinholeCamera& camera : {smallCamera(), PinholeCamera(tilted, kWidth, kHeight)}) {
      const FragmentImage image = rasterize(camera, mesh);
      for (const Fragment& f : image) {
        ASSERT_TRUE(!f.covered() || (f.t >= 0.99f * camera.view().zNear && f.t <= 1.01f * camera.view().zFar)) << f.t;
      }
    }
  }
}

// A plane under and behind the eye, cut into a fan: triangles that share an edge, drawn one by one, never overlap, and
// leave no gap where the plane is seen.
TEST(Rasterize, clippedNeighboursNeitherOverlapNorGape) {
  const PinholeCamera camera = smallCamera();
  std::mt19937 random(11);
  const auto next = [&] { return static_cast<float>(random() >> 8) / static_cast<float>(1 << 23) - 1; };
  for (int round = 0; round < 25; ++round) {
    const glm::mat4 turn =
        glm::rotate(glm::rotate(glm::mat4(1), 0.4f * next(), glm::vec3(1, 0, 0)), 0.4f * next(), glm::vec3(0, 0, 1));
    // Through (0, -1.2, 10), below the eye.
    const auto onPlane = [&](float x, float z) {
      return glm::vec3(turn * glm::vec4(x, 0, z, 0)) + glm::vec3(0, -1.2f, 10);
    };
    const glm::vec3 hub = onPlane(20 * next(), 20 * next());
    std::vector<glm::vec3> rim;
    for (int i = 0; i < 9; ++i) {
      const float angle = 2 * static_cast<float>(kPi) * (static_cast<float>(i) + 0.4f * next()) / 9;
      rim.push_back(onPlane(90 * std::cos(angle), 90 * std::sin(angle)));
    }
    Image<int> count(kWidth, kHeight, 0);
    for (size_t i = 0; i < rim.size(); ++i) {
      Mesh mesh;
      mesh.positions = {hub, rim[i], rim[(i + 1) % rim.size()]};
      mesh.triangles.emplace_back(0, 1, 2);
      const FragmentImage image = rasterize(camera, mesh);
      for (size_t k = 0; k < image.size(); ++k) {
        count[k] += image[k].covered();
      }
    }
    const glm::vec3 normal(turn * glm::vec4(0, 1, 0, 0));
    forPixels([&](int x, int y, const glm::dvec2& centre) {
      ASSERT_LE(count(x, y), 1) << x << " " << y << " round " << round;
      // Depth of the plane on this ray; the rim is at least 50 units away from the foot of the eye.
      const glm::vec3 direction = camera.worldFromCamera(camera.cameraFromImage(
                                      {static_cast<float>(centre.x), static_cast<float>(centre.y), 1})) -
                                  camera.eye();
      const float depth = glm::dot(normal, glm::vec3(0, -1.2f, 0)) / glm::dot(normal, direction);
      if (depth > 0.02f && depth < 45) {
        ASSERT_EQ(count(x, y), 1) << x << " " << y << " round " << round;
      }
    });
  }
}

TEST(Rasterize, sameBytesWithAnyNumberOfThreads) {
  const Mesh mesh = test::randomTriangles(9000, 3);  // several blocks of 2048
  setThreadCount(1);
  const FragmentImage one = rasterize(smallCamera(), mesh);
  for (const int threads : {2, 8}) {
    setThreadCount(threads);
    EXPECT_TRUE(test::sameBytes(rasterize(smallCamera(), mesh), one)) << threads;
  }
  setThreadCount(0);
  EXPECT_GT(coveredPixels(one), one.size() / 2);
}

// Snapping moves the image of a triangle by up to kSnapPixels; single precision in the ray caster (coordinates of 10
// units, footprints of 0.03) by about as much as 1e-3 pixels. So the two may disagree on which triangle is seen only at
// pixels whose centre is that close to an edge, or where two triangles cross.
TEST(Rasterize, agreesWithRayCasting) {
  const PinholeCamera camera = smallCamera();
  constexpr double kRayPixels = 1e-3;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Mesh mesh = test::randomTriangles(seed * 40, seed);
    const FragmentImage drawn = rasterize(camera, mesh);
    const FragmentImage cast = raycast(camera, mesh, RayScene(mesh));
    size_t different = 0;
    forPixels([&](int x, int y, const glm::dvec2& centre) {
      const Fragment& d = drawn(x, y);
      const Fragment& c = cast(x, y);
      if (d.triangle != c.triangle) {
        ++different;
        EXPECT_TRUE(mayDiffer(d, c, camera, mesh, x, y, kSnapPixels + kRayPixels)) << x << " " << y << " seed " << seed;
      } else if (d.covered()) {
        const TriangleImage image(camera, mesh, d.triangle);
        const double slope = glm::length(image.slope);
        const double inverseZ = image.inverseZ(centre);
        EXPECT_NEAR(1 / d.t, inverseZ, slope * kSnapPixels + 2e-6 * inverseZ);
        EXPECT_NEAR(1 / c.t, inverseZ, slope * kRayPixels + 2e-6 * inverseZ);
      }
    });
    EXPECT_LT(different, drawn.size() / 50);
    EXPECT_GT(coveredPixels(drawn), drawn.size() / 4);
  }
}

}  // namespace
}  // namespace ocelli
