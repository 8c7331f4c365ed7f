#include "oc_core/render/rasterize_subdivided.h"

#include <gtest/gtest.h>

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/raycast.h"
#include "tests/ocri/test_scenes.h"
#include "tests/render/render_checks.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kSnapPixels;
using test::kWidth;
using test::smallCamera;

DdocCamera wavyCamera() {
  return {smallCamera(), test::wavyMap(kWidth, kHeight, 3, 40)};
}

/// The plane through z = -1, tilted, of `cells` x `cells` quads; it fills the image of the wavy camera.
Mesh gridPlane(int cells) {
  Mesh mesh;
  const auto point = [&](int i, int j) {
    const float x = 6 * (static_cast<float>(i) / static_cast<float>(cells) - 0.5f);
    const float y = 6 * (static_cast<float>(j) / static_cast<float>(cells) - 0.5f);
    return glm::vec3(x, y, -1 + 0.3f * x - 0.4f * y);
  };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      mesh.positions.push_back(point(i, j));
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<uint32_t>(j * (cells + 1) + i);
      const auto b = a + static_cast<uint32_t>(cells) + 1;
      mesh.triangles.emplace_back(a, a + 1, b + 1);
      mesh.triangles.emplace_back(a, b + 1, b);
    }
  }
  return mesh;
}

/// Where the reference pinhole sees the surface point of a fragment.
glm::dvec2 undistorted(const Fragment& fragment, const Mesh& mesh) {
  const PinholeCamera camera = smallCamera();
  const ImagePoint q = camera.imageFromCamera(camera.cameraFromWorld(positionOf(fragment, mesh)));
  return {q.u, q.v};
}

// The pieces of a triangle are snapped one by one, so its edges may be off by a snap, and no more.
TEST(RasterizeSubdivided, zeroMapGivesThePinholesImage) {
  const PinholeCamera camera = smallCamera();
  const DdocCamera flat(camera, DistortionMap(kWidth, kHeight, DistortionMap::Lookup::kBilinear));
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Mesh mesh = test::randomTriangles(seed * 30, seed);
    const FragmentImage whole = rasterize(camera, mesh);
    const FragmentImage pieces = rasterize(flat, mesh);
    size_t different = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Fragment& w = whole(x, y);
        const Fragment& p = pieces(x, y);
        if (w.triangle != p.triangle) {
          ++different;
          EXPECT_TRUE(test::mayDiffer(w, p, camera, mesh, x, y, 2 * kSnapPixels + 1e-4)) << x << " " << y;
        } else if (w.covered()) {
          const test::TriangleImage image(camera, mesh, w.triangle);
          const double inverseZ = image.inverseZ({x + 0.5, y + 0.5});
          EXPECT_NEAR(1 / p.t, inverseZ, glm::length(image.slope) * (kSnapPixels + 1e-4) + 2e-6 * inverseZ);
        }
      }
    }
    EXPECT_LT(different, whole.size() / 50);
  }
}

/// The same camera without what is known about where it displaces: every triangle is split and drawn.
struct DrawnWholly : DdocCamera {
  using DdocCamera::DdocCamera;
  bool displacesWithin(const ImageBox&) const { return true; }
};

// Pieces end at other places than whole triangles, so their edges may be off by a snap, and no more. Nothing else may
// differ where the map displaces only in the middle of the image.
TEST(RasterizeSubdivided, whatIsNotDisplacedIsThePinholes) {
  const PinholeCamera camera = smallCamera();
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kBilinear);
  const DistortionMap wavy = test::wavyMap(kWidth, kHeight, 3, 40);
  for (int y = 20; y < 40; ++y) {
    for (int x = 30; x < 60; ++x) {
      map.samples()(x, y) = wavy.samples()(x, y);
    }
  }
  const DdocCamera quick(camera, map);
  const DrawnWholly slow(camera, map);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Mesh mesh = test::randomTriangles(seed * 100, seed);
    const FragmentImage got = rasterize(quick, mesh);
    const FragmentImage expected = rasterize(slow, mesh);
    const FragmentImage pinhole = rasterize(camera, mesh);
    int different = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        different += got(x, y).triangle != expected(x, y).triangle;
        if (got(x, y).triangle == expected(x, y).triangle && got(x, y).covered()) {
          const test::TriangleImage image(camera, mesh, got(x, y).triangle);
          EXPECT_NEAR(1 / got(x, y).t, 1 / expected(x, y).t, glm::length(image.slope) * 0.3 + 2e-6) << x << " " << y;
        }
        // The longest displacement is 4.3 pixels.
        if (x < 24 || x >= 66 || y < 14 || y >= 46) {
          EXPECT_EQ(got(x, y), pinhole(x, y)) << x << " " << y;
        }
      }
    }
    EXPECT_LT(different, kWidth * kHeight / 50);
    EXPECT_LT(displacedPart(quick, mesh).size(), mesh.triangles.size());
  }
}

TEST(RasterizeSubdivided, drawsAPartAsItDrawsTheWhole) {
  const Mesh mesh = test::ballBeforePlane();
  const DdocCamera camera = wavyCamera();
  const FragmentImage seen = rasterize(smallCamera(), mesh);
  EXPECT_TRUE(test::sameBytes(rasterize(camera, seen, displacedPart(camera, mesh)), rasterize(camera, mesh)));
}

// How far the straight edge of a piece, a pixel long, may be off: a quarter of the turn that the field takes on it. At
// each sample of the bilinear map that is the curvature 3 (2 pi / 40)^2 = 0.074, so 0.02 pixels, for u and for v; twice
// with the snap and what the ray caster is off. Along the border of the map, beyond which the field is constant, it is
// the whole slope 3 (2 pi / 40) = 0.47, so 0.12 pixels. Displacements are at most 3 pixels.
double piecePixels(int x, int y) {
  return std::min({x, y, kWidth - 1 - x, kHeight - 1 - y}) < 4 ? 0.15 : 0.05;
}

TEST(RasterizeSubdivided, planesHaveNoCracksHoweverTheyAreCut) {
  const DdocCamera camera = wavyCamera();
  const FragmentImage coarse = rasterize(camera, gridPlane(1));
  const FragmentImage fine = rasterize(camera, gridPlane(57));
  const Mesh coarseMesh = gridPlane(1);
  const Mesh fineMesh = gridPlane(57);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_TRUE(coarse(x, y).covered()) << x << " " << y;
      ASSERT_TRUE(fine(x, y).covered()) << x << " " << y;
      EXPECT_LT(glm::distance(undistorted(coarse(x, y), coarseMesh), undistorted(fine(x, y), fineMesh)),
                piecePixels(x, y));
    }
  }
}

TEST(RasterizeSubdivided, everyFragmentProjectsToItsPixel) {
  const DdocCamera camera = wavyCamera();
  const Mesh mesh = gridPlane(5);
  const FragmentImage image = rasterize(camera, mesh);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::optional<ImagePoint> q = camera.project(positionOf(image(x, y), mesh));
      ASSERT_TRUE(q);
      EXPECT_NEAR(q->u, x + 0.5, piecePixels(x, y));
      EXPECT_NEAR(q->v, y + 0.5, piecePixels(x, y));
      EXPECT_NEAR(q->t, image(x, y).t, 1e-4) << "rounding of weights on cells of a unit";
    }
  }
}

TEST(RasterizeSubdivided, agreesWithRayCastingAlongTheRays) {
  const DdocCamera camera = wavyCamera();
  const Mesh mesh = test::ballBeforePlane();
  const FragmentImage drawn = rasterize(camera, mesh);
  const FragmentImage cast = raycast(camera, mesh, RayScene(mesh));
  const auto isRim = [&](int x, int y) {
    // The ball's silhouette, where the depth steps by more than a unit or a part of it, passes within a pixel.
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, kHeight - 1); ++v) {
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, kWidth - 1); ++u) {
        if (std::abs(cast(u, v).t - cast(x, y).t) > 0.3f) {
          return true;
        }
      }
    }
    return false;
  };
  int rim = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_TRUE(drawn(x, y).covered() && cast(x, y).covered()) << x << " " << y;
      if (isRim(x, y)) {
        ++rim;
        continue;
      }
      // The ray caster follows 96 straight steps and stops solving within 1e-3 pixels: an order below the pieces.
      EXPECT_LT(glm::distance(undistorted(drawn(x, y), mesh), undistorted(cast(x, y), mesh)), piecePixels(x, y))
          << x << " " << y;
    }
  }
  EXPECT_GT(rim, 60);
  EXPECT_LT(rim, 600);
}

// The left half of the image is pushed to the left by 10 pixels, the right half to the right: a gap of 20 columns opens
// at the middle, and nothing may be stretched over it.
TEST(RasterizeSubdivided, tornEdgesAreNotDrawn) {
  DistortionMap map(kWidth, kHeight, DistortionMap::Lookup::kNearest);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      map.samples()(x, y) = {{x < kWidth / 2 ? -10 : 10, 0}, 1 / 8.0f, 1 / 9.0f};
    }
  }
  const FragmentImage image = rasterize(DdocCamera(smallCamera(), map), test::wall(-1));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_EQ(image(x, y).covered(), x < 35 || x >= 55) << x << " " << y;
    }
  }
}

TEST(RasterizeSubdivided, absurdCoordinatesDoNoHarm) {
  for (const float huge : {1e12f, 1e30f, 3e38f}) {
    Mesh mesh = test::randomTriangles(12, 5);
    for (size_t i = 0; i < mesh.positions.size(); i += 2) {
      mesh.positions[i] *= huge;
    }
    View tilted;
    tilted.eye = {5, 6, 7};
    const PinholeCamera reference(tilted, kWidth, kHeight);
    const FragmentImage image = rasterize(DdocCamera(reference, test::wavyMap(kWidth, kHeight, 3, 40)), mesh);
    for (const Fragment& f : image) {
      ASSERT_TRUE(!f.covered() || (f.t > 0.009f && f.t < 1001)) << f.t;
    }
  }
}

TEST(RasterizeSubdivided, sameBytesWithAnyNumberOfThreads) {
  // Several blocks of 2048 triangles, each a tenth as large as its corners are apart.
  Mesh mesh = test::randomTriangles(5000, 3);
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
    for (int i = 0; i < 3; ++i) {
      mesh.positions[t[i]] = middle + (mesh.positions[t[i]] - middle) * 0.1f;
    }
  }
  setThreadCount(1);
  const FragmentImage one = rasterize(wavyCamera(), mesh);
  for (const int threads : {2, 8}) {
    setThreadCount(threads);
    EXPECT_TRUE(test::sameBytes(rasterize(wavyCamera(), mesh), one)) << threads;
  }
  setThreadCount(0);
}

}  // namespace
}  // namespace ocelli
