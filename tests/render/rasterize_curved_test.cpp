#include "oc_core/render/rasterize_curved.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/render/bend_rasterizer.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/densify.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/render/ray_agreement.h"
#include "tests/render/render_checks.h"

namespace ocelli {
namespace {

using test::bendingRight;
using test::bendingTwice;
using test::coveredPixels;
using test::Disagreement;
using test::disagreement;

PinholeCamera camera() {
  return {View{}, 180, 120};
}

/// Turns by little, to and fro.
CurvedRayCamera bendingOften(const PinholeCamera& root, int turns) {
  CurvedRayCamera curved(root);
  for (int i = 0; i < turns; ++i) {
    const double z = 1 - 0.6 * i;
    const double side = i % 2 == 0 ? 1 : -1;
    curved.bend(test::planesThrough({8 * side, 0, z}, {-0.03 * side, 0, -1}, {0, 0, -1}, {0.03 * side, 0, -1}),
                {side > 0 ? -0.3 : 0, 0, 9.5 - 0.5 * i});
  }
  return curved;
}

TEST(RasterizeCurved, withoutBendsItIsThePinhole) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const FragmentImage expected = rasterize(camera(), mesh);
  const Disagreement d = disagreement(expected, rasterize(CurvedRayCamera(camera()), mesh), 1e-5f);
  EXPECT_LE(d.differing, d.samples / 1000) << d;
}

// Rays are cast along polylines, whose corners lie on the arcs: they are off by 0.007 pixels, hence 1e-3 of the depth.
// Images are of a width at which no bar of the fence ends at that distance of a column of pixel centres.
TEST(RasterizeCurved, agreesWithRayCasting) {
  const PinholeCamera odd(View{}, 196, 130);
  for (const char* scene : {"builtin:boxes", "builtin:statues", "builtin:fence,gap=4", "builtin:room"}) {
    const Mesh mesh = loadScene(scene, {}, {});
    const RayScene rays(mesh);
    for (const CurvedRayCamera& curved :
         {bendingRight(odd), bendingTwice(odd), bendingOften(odd, 8), bendingTwice(odd, ArcModel::kBezier)}) {
      const FragmentImage cast = raycast(curved, mesh, rays);
      const Disagreement d = disagreement(cast, rasterize(curved, mesh), 1e-3f);
      EXPECT_GT(d.samples, 2000u);
      EXPECT_LE(d.differing, d.samples / 200) << scene << ": " << d;
      EXPECT_LE(d.apart, d.samples / 5000) << scene << ": " << d;
    }
  }
}

TEST(RasterizeCurved, showsPointsWhereTheyAre) {
  const Mesh mesh = loadScene("builtin:room", {}, {});
  const CurvedRayCamera curved = bendingTwice(PinholeCamera(View{}, 360, 240));
  const FragmentImage image = rasterize(curved, mesh);
  size_t seen = 0;
  size_t missed = 0;
  double farthest = 0;
  double depth = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!image(x, y).covered()) {
        continue;
      }
      ++seen;
      const auto q = curved.projectExactly(glm::dvec3(positionOf(image(x, y), mesh)));
      if (!q) {
        ++missed;
        continue;
      }
      farthest = std::max(farthest, glm::distance(glm::dvec2(q->u, q->v), {x + 0.5, y + 0.5}));
      depth = std::max(depth, std::abs(static_cast<double>(image(x, y).t) / q->t - 1));
    }
  }
  EXPECT_GT(seen, 20000u);
  EXPECT_EQ(missed, 0u);
  // A sample lies between the corners of its piece, and each of its edges is off by as much as the error allows.
  EXPECT_LT(farthest, 2 * BendRasterizer::kErrorPixels);
  EXPECT_LT(depth, 1e-4);
}

// Closed around all that the rays pass: no pixel may see through a crack between triangles, pieces or planes.
TEST(RasterizeCurved, wallsAllAroundLeaveNoCrack) {
  Mesh box;
  append(box, makeBox({3.5f, 2.6f, 20}), glm::translate(glm::mat4(1), glm::vec3(0.2f, 0.1f, -8)));
  for (const size_t triangles : {12, 5000}) {
    for (int turned = 0; turned < 4; ++turned) {
      Mesh mesh;
      append(mesh, box, glm::rotate(glm::mat4(1), 0.05f * static_cast<float>(turned), glm::vec3(0.2f, 0.6f, 0.7f)));
      densify(mesh, triangles);
      for (const CurvedRayCamera& curved :
           {bendingRight(camera()), bendingTwice(camera()), bendingOften(camera(), 5)}) {
        EXPECT_EQ(coveredPixels(rasterize(curved, mesh)), 180u * 120) << triangles << ", " << turned;
      }
    }
  }
}

TEST(RasterizeCurved, earlierPiecesHideLaterOnes) {
  // Walls before, in and behind the turn, each smaller than the one before it.
  Mesh mesh;
  for (int i = 0; i < 3; ++i) {
    test::addWall(mesh, 3.0f - 3 * static_cast<float>(i), 1.5f - 0.2f * static_cast<float>(i));
  }
  for (const int first : {0, 1, 2}) {
    Mesh part = mesh;
    part.triangles.erase(part.triangles.begin(), part.triangles.begin() + 2 * first);
    const FragmentImage image = rasterize(bendingRight(camera()), part);
    EXPECT_TRUE(image(90, 60).covered());
    EXPECT_LT(image(90, 60).triangle, 2u);
  }
}

TEST(RasterizeCurved, sameBytesForAnyNumberOfThreads) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const CurvedRayCamera curved = bendingTwice(camera());
  setThreadCount(1);
  const FragmentImage one = rasterize(curved, mesh);
  setThreadCount(5);
  EXPECT_EQ(one, rasterize(curved, mesh));
  setThreadCount(0);
}

TEST(RasterizeCurved, brokenTrianglesLeaveTheirNeighboursAlone) {
  const CurvedRayCamera curved = bendingTwice(camera());
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  const FragmentImage whole = rasterize(curved, mesh);
  test::addBrokenTriangles(mesh);
  EXPECT_EQ(whole, rasterize(curved, mesh));
  EXPECT_EQ(coveredPixels(rasterize(curved, Mesh{})), 0u);
}

// Sizes from nothing to the largest numbers: what is drawn lies on rays of the camera.
TEST(RasterizeCurved, enduresAnySize) {
  const CurvedRayCamera curved = bendingTwice();
  for (const float size : {1e-30f, 1e-6f, 1e6f, 1e20f, 3e38f}) {
    const Mesh mesh{{{-size, -size, 0}, {size, -size, -1}, {0, size, 1}, {0, size, -size}}, {}, {{0, 1, 2}, {0, 1, 3}}};
    for (const Fragment& f : rasterize(curved, mesh)) {
      EXPECT_TRUE(!f.covered() || (f.t > 0 && std::isfinite(f.b1) && std::isfinite(f.b2)));
    }
  }
}

}  // namespace
}  // namespace ocelli
