#include "oc_core/render/rasterize_spans.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "tests/camera/random_edges.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

const glm::vec3 kRight{1.6f, 0, 10};
const glm::vec3 kForward{0, 0, 8.6f};

EpipolarCamera randomCamera(const glm::vec3& right, unsigned seed) {
  return {smallCamera(), right, test::randomEdges(EpipolarLines(smallCamera(), right), seed)};
}

EpipolarCamera withoutEdges(const glm::vec3& right) {
  const EpipolarLines lines(smallCamera(), right);
  return {smallCamera(), right, std::vector<std::vector<EpipolarEdge>>(static_cast<size_t>(lines.rowCount()))};
}

/// Pixels, in every direction, by which two renderers may see an edge at different places: the pinhole's rasteriser
/// snaps vertices to 1/256 pixel, single precision of world coordinates moves points and rays by some 2e-4, and a ray
/// ends up to 0.01 pixels before the next one.
constexpr double kDifference = 0.02;

/// Whether the path of a pixel and its neighbours within kDifference meet different things, so that a renderer may show
/// either.
bool isUncertain(const EpipolarCamera& camera, const Mesh& mesh, const RayScene& scene, int x, int y,
                 const Fragment& seen) {
  const auto isSame = [&](const Fragment& a) {
    if (a.triangle == seen.triangle) {
      return true;
    }
    if (!a.covered() || !seen.covered()) {
      return false;
    }
    return glm::distance(positionOf(a, mesh), positionOf(seen, mesh)) < 2e-3f;  // two triangles at a common edge
  };
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::vec2 pixel(x + 0.5 + dx * kDifference, y + 0.5 + dy * kDifference);
      if (isSame(scene.intersect(camera.rayPath(pixel)))) {
        return true;
      }
    }
  }
  return false;
}

struct Comparison {
  size_t covered = 0;
  size_t hidden = 0;  ///< covered on rays that bend
  size_t uncertain = 0;
  size_t wrong = 0;
};

Comparison compareWithRaycast(const EpipolarCamera& camera, const Mesh& mesh) {
  const RayScene scene(mesh);
  const FragmentImage spans = rasterize(camera, mesh);
  const FragmentImage rays = raycast(camera, mesh, scene);
  Comparison comparison;
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      const Fragment& a = spans(x, y);
      const Fragment& b = rays(x, y);
      comparison.covered += b.covered();
      const auto ray = camera.planeRay(y, x + 0.5);
      comparison.hidden += b.covered() && ray && std::isfinite(ray->yFar);
      // Depths of a steep surface differ by what kDifference pixels make.
      const bool same = a.covered() == b.covered() &&
                        (!a.covered() || glm::distance(positionOf(a, mesh), positionOf(b, mesh)) < 2e-3f);
      if (!same) {
        ++(isUncertain(camera, mesh, scene, x, y, a) ? comparison.uncertain : comparison.wrong);
      }
    }
  }
  return comparison;
}

TEST(RasterizeSpans, agreesWithRaycastingWhateverTheEdges) {
  for (const glm::vec3& right : test::segmentEnds()) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      for (const Mesh& mesh : {test::boxBeforeWall(), test::ballBeforePlane(), test::randomTriangles(150, seed)}) {
        const Comparison comparison = compareWithRaycast(randomCamera(right, seed), mesh);
        EXPECT_GT(comparison.hidden, 100u);
        EXPECT_LE(comparison.wrong, comparison.covered / 1000) << right.x << " " << right.z << " seed " << seed;
        EXPECT_LE(comparison.uncertain, comparison.covered / 20);
      }
    }
  }
}

TEST(RasterizeSpans, isThePinholesImageWithoutEdges) {
  for (const Mesh& mesh : {test::boxBeforeWall(), test::ballBeforePlane(), test::randomTriangles(300, 5)}) {
    EXPECT_EQ(rasterize(withoutEdges(kRight), mesh), rasterize(smallCamera(), mesh));
  }
}

TEST(RasterizeSpans, linesOfARingHoldWhatThePinholeSeesThere) {
  const Mesh mesh = test::ballBeforePlane();
  const PinholeCamera base = smallCamera();
  const EpipolarLines lines(base, kForward);
  const FragmentImage fragments = rasterizeLines(base, lines, mesh);
  const RayScene scene(mesh);
  size_t wrong = 0;
  for (int row = 0; row < lines.rowCount(); ++row) {
    for (int j = 0; j < lines.length(row); ++j) {
      const glm::vec2 pixel(lines.imagePoint({row + 0.5, j + 0.5}));
      const Fragment truth = scene.intersect(base.rayPath(pixel));
      ASSERT_TRUE(fragments(j, row).covered()) << "the plane fills the image: no crack";
      wrong += glm::distance(positionOf(fragments(j, row), mesh), positionOf(truth, mesh)) > 2e-3f;
    }
  }
  // The silhouette of the ball is some 90 pixels long.
  EXPECT_LE(wrong, 10u);
}

// The wall is two triangles whose common edge runs through the image, and behind a box that hides it from L.
TEST(RasterizeSpans, leavesNoCracksInWhatIsHidden) {
  for (const glm::vec3& right : test::segmentEnds()) {
    const EpipolarCamera camera = randomCamera(right, 11);
    const Mesh mesh = test::wall(0, 30);
    const FragmentImage fragments = rasterize(camera, mesh);
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        const auto ray = camera.planeRay(y, x + 0.5);
        const PinholeCamera& base = camera.base();
        if (!ray) {
          EXPECT_FALSE(fragments(x, y).covered());
          continue;
        }
        const RayPath path = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const bool meets = path.size() > 1 && base.cameraFromWorld(path.front()).z < 10 - 1e-3f &&
                           base.cameraFromWorld(path.back()).z > 10 + 1e-3f;
        EXPECT_TRUE(fragments(x, y).covered() || !meets) << x << " " << y;
      }
    }
  }
}

TEST(RasterizeSpans, samplesLieOnTheirRays) {
  for (const glm::vec3& right : test::segmentEnds()) {
    const EpipolarCamera camera = randomCamera(right, 3);
    const Mesh mesh = test::ballBeforePlane();
    const FragmentImage fragments = rasterize(camera, mesh);
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        if (fragments(x, y).covered()) {
          const glm::vec3 point = positionOf(fragments(x, y), mesh);
          const ImagePoint q = *camera.project(point);
          const float z = fragments(x, y).t;
          EXPECT_NEAR(z, q.t, 1e-4f * q.t);
          // Pinhole vertices snap to 1/256 pixel; hidden samples are exact.
          EXPECT_NEAR(q.u, static_cast<float>(x) + 0.5f, 0.03f) << right.x << " " << right.z << " " << y;
        }
      }
    }
  }
}

TEST(RasterizeSpans, sameBytesWithAnyNumberOfThreads) {
  for (const glm::vec3& right : {kRight, kForward}) {
    const EpipolarCamera camera = randomCamera(right, 2);
    const Mesh mesh = test::randomTriangles(5000, 9);
    setThreadCount(1);
    const FragmentImage fragments = rasterize(camera, mesh);
    for (const int threads : {2, 8}) {
      setThreadCount(threads);
      EXPECT_TRUE(test::sameBytes(rasterize(camera, mesh), fragments));
    }
    setThreadCount(0);
  }
}

TEST(RasterizeSpans, survivesHostileMeshes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const glm::vec3& right : test::segmentEnds()) {
    const EpipolarCamera camera = randomCamera(right, 4);
    EXPECT_EQ(rasterize(camera, Mesh{}), FragmentImage(camera.width(), camera.height()));
    Mesh hostile = test::wall(0, 30);
    const auto first = static_cast<uint32_t>(hostile.positions.size());
    for (const glm::vec3& p :
         {glm::vec3(nan, 0, 0), glm::vec3(infinity, 0, 5), glm::vec3(0, -infinity, 1), glm::vec3(0.1f),
          glm::vec3(1e30f, -1e30f, 2), glm::vec3(0, 0, 10), glm::vec3(0.2f, 0.1f, 20)}) {
      hostile.positions.push_back(p);
      hostile.colors.emplace_back(1);
    }
    for (uint32_t i = 0; i < 7; ++i) {
      hostile.triangles.emplace_back(first + i, first + (i + 1) % 7, first + 3);
      hostile.triangles.emplace_back(first + i, first + i, first + i);
    }
    for (const Fragment& fragment : rasterize(camera, hostile)) {
      EXPECT_TRUE(!fragment.covered() || (std::isfinite(fragment.t) && fragment.t > 0));
    }
  }
}

}  // namespace
}  // namespace ocelli
