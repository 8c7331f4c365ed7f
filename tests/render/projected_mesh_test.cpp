#include "oc_core/render/projected_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/frustum_clip.h"
#include "oc_core/render/rasterize.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

TEST(ProjectedMesh, projectsAsThePinholeDoes) {
  Mesh mesh = test::randomTriangles(500, 3);
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 1000}, {0, 0, -1e30f}, {1e38f, 0, 0}, {NAN, 0, 0}});
  const PinholeCamera camera = smallCamera();
  const ProjectedMesh projected(camera, mesh);
  for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const std::optional<ImagePoint> q = camera.project(mesh.positions[i]);
    const ProjectedVertex& vertex = projected.vertex(i);
    ASSERT_EQ(vertex.inverseZ, q ? 1 / q->t : 0) << i;
    if (q) {
      EXPECT_EQ(vertex.u, q->u);
      EXPECT_EQ(vertex.v, q->v);
    }
  }
}

size_t pixelsOf(const std::array<glm::vec2, 3>& p) {
  size_t pixels = 0;
  scanTriangle(kWidth, kHeight, {p[0].x, p[0].y, 1}, {p[1].x, p[1].y, 1}, {p[2].x, p[2].y, 1},
               [&](size_t, float, const auto&) { ++pixels; });
  return pixels;
}

bool missesCentres(const std::array<glm::vec2, 3>& p) {
  return CentreCell::missCentres({p[0].x, p[0].y}, {p[1].x, p[1].y}, {p[2].x, p[2].y});
}

// Half of the points lie on the grid that points are snapped to, many of them at pixel centres, others near halves of
// it.
TEST(CentreCell, leavesOutNoTriangleThatCoversACentre) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(2, 6);
  std::uniform_real_distribution<float> offset(-0.6f, 0.6f);
  size_t leftOut = 0;
  size_t empty = 0;
  for (int i = 0; i < 200000; ++i) {
    const glm::vec2 centre(place(random), place(random));
    std::array<glm::vec2, 3> points;
    for (glm::vec2& p : points) {
      p = centre + glm::vec2(offset(random), offset(random));
      const float grid = i % 2 == 0 ? 256.0f : i % 3 == 0 ? 2.0f : 0.0f;
      p = grid > 0 ? glm::round(p * grid) / grid : p;
    }
    const size_t pixels = pixelsOf(points);
    if (missesCentres(points)) {
      ++leftOut;
      ASSERT_EQ(pixels, 0u) << i;
    }
    empty += pixels == 0;
  }
  EXPECT_GT(leftOut, empty / 4) << "it is worth its time";
}

TEST(CentreCell, decidesAtTheCentreItself) {
  const float below = 2.5f - 1.0f / 256;
  const float above = 2.5f + 1.0f / 256;
  // To the left of the centres of column 2, on them, to the right of them; from above to below centres.
  EXPECT_TRUE(missesCentres({{{2, 2.4f}, {below, 2.6f}, {below, 2.8f}}}));
  EXPECT_FALSE(missesCentres({{{2, 2.4f}, {2.5f, 2.6f}, {below, 2.8f}}}));
  EXPECT_FALSE(missesCentres({{{2.5f, 2.4f}, {2.5f, 2.6f}, {2.5f, 2.8f}}}));
  EXPECT_FALSE(missesCentres({{{2, 2.4f}, {above, 2.6f}, {below, 2.8f}}}));
  EXPECT_TRUE(missesCentres({{{3, 2.4f}, {above, 2.6f}, {above, 2.8f}}}));
  EXPECT_FALSE(CentreCell::missCentres(CentreCell::unknown(), CentreCell::unknown(), CentreCell::unknown()));
}

/// The slow reference: every triangle is clipped and drawn.
FragmentImage drawnOneByOne(const PinholeCamera& camera, const Mesh& mesh) {
  VisibilityBuffer buffer(camera.width(), camera.height());
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const ClipPolygon polygon =
        clipToFrustum({camera.cameraFromWorld(mesh.positions[t.x]), camera.cameraFromWorld(mesh.positions[t.y]),
                       camera.cameraFromWorld(mesh.positions[t.z])},
                      camera, kClipMargin);
    const auto vertex = [&](size_t k) {
      const ClipVertex& v = polygon.vertices[k];
      const ImagePoint q = camera.imageFromCamera(v.p);
      return RasterVertex{q.u, q.v, 1 / q.t, v.b1, v.b2};
    };
    for (size_t k = 2; k < polygon.count; ++k) {
      buffer.draw(i, vertex(0), vertex(k - 1), vertex(k));
    }
  }
  FragmentImage fragments(camera.width(), camera.height());
  for (size_t i = 0; i < fragments.size(); ++i) {
    fragments[i] = buffer.fragment(i);
  }
  return fragments;
}

/// A ball of triangles most of which are smaller than a pixel.
Mesh denseBall() {
  Mesh mesh;
  constexpr int kRings = 120;
  for (int i = 0; i <= kRings; ++i) {
    for (int j = 0; j <= kRings; ++j) {
      const float a = static_cast<float>(i) * 3.14159f / kRings;
      const float b = static_cast<float>(j) * 6.28318f / kRings;
      mesh.positions.emplace_back(std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b));
      if (i > 0 && j > 0) {
        const auto at = static_cast<uint32_t>(i * (kRings + 1) + j);
        mesh.triangles.emplace_back(at, at - 1, at - kRings - 1);
        mesh.triangles.emplace_back(at - 1, at - kRings - 2, at - kRings - 1);
      }
    }
  }
  return mesh;
}

TEST(ProjectedMesh, isDrawnAsItsTrianglesOneByOne) {
  const PinholeCamera camera = smallCamera();
  for (const Mesh& mesh : {denseBall(), test::randomTriangles(300, 5), test::boxBeforeWall()}) {
    EXPECT_TRUE(test::sameBytes(rasterize(ProjectedMesh(camera, mesh)), drawnOneByOne(camera, mesh)));
  }
}

}  // namespace
}  // namespace ocelli
