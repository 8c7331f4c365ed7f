// Chapter 6 in one table: every camera, drawn by every technique, against ray casting along its rays (Embree).
//
// A new camera is one line in forEachCamera(), a new technique one in forEachTechnique().
#include <gtest/gtest.h>

#include <cstdio>
#include <type_traits>

#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/hybrid_raycast.h"
#include "oc_core/render/points.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/ocri/test_scenes.h"
#include "tests/render/camera_cases.h"

namespace ocelli {
namespace {

constexpr int kMatrixWidth = 240;
constexpr int kMatrixHeight = 160;

/// What a technique may get wrong, as shares of the pixels at silhouettes.
struct Bounds {
  double stray;      ///< coverage or depth that no ray of the 3x3 pixels around has
  double different;  ///< coverage other than that of the pixel's own ray
};

// The rays of a depth discontinuity camera are solved for, and where its field folds one of several solutions is
// returned or none: the camera's contract allows 1 % of all pixels that, and half of it is all these scenes need.
constexpr double kFolds = 0.005;

/// Calls visit(name, camera, share of pixels whose ray is not the only one).
template <class Visit>
void forEachCamera(const PinholeCamera& reference, const Mesh& mesh, const Visit& visit) {
  visit("ppc", reference, 0.0);
  visit("rppc", buildReversePinhole(reference, mesh), 0.0);
  visit("spoc", buildSpocCamera(reference, mesh), 0.0);
  visit("spoc-", buildSpocCamera(reference, mesh, {.farDisplacementPerHeight = 0.2f, .maskPole = false}), 0.0);
  visit("gpc", GpcCamera(reference, test::oneRegion("cubic")), 0.0);
  visit("gpc2", GpcCamera(reference, test::twoRegions("quadratic")), 0.0);
  visit("ddoc", buildDdocCamera(reference, mesh), kFolds);
}

/// Calls visit(name, image, bounds).
template <class C, class Visit>
void forEachTechnique(const C& camera, const Mesh& mesh, const Visit& visit) {
  // Vertices are snapped to 1/256 pixel and pieces are a pixel large with an error of a few hundredths (see
  // rasterize_subdivided_test.cpp), so an edge that passes a pixel centre nearer than that may fall on the other side:
  // twice that share of the pixels at silhouettes. Only pieces that lie across a tear are left out altogether.
  visit("subdivided", rasterize(camera, mesh), Bounds{0.01, 0.1});
  if constexpr (std::is_same_v<C, GpcCamera>) {
    // Nothing is subdivided: only snapping is left of the above, 2/256 of the pixels at silhouettes.
    visit("pieces", rasterizeGpc(camera, mesh), Bounds{0.01, 0.02});
  }
  // A splat reaches half a pixel farther than the surface, so half of the pixels on the outer side of a silhouette,
  // which are half of those at it, are covered in addition; with those at corners, a third. Where the surface turns
  // away at its limb their depth may be one that it reaches between the rays.
  visit("points", renderPoints(camera, mesh), Bounds{0.25, 0.36});
  // The same rays, and tests of one precision or another: only rounding differs.
  visit("hybrid", hybridRaycast(camera, mesh), Bounds{0, 0.001});
}

struct Agreement {
  double different = 0;    ///< share of pixels: covered, and the pixel's own ray meets nothing, or the other way around
  double stray = 0;        ///< share of pixels: so for all rays around, or a depth outside of what they have
  double silhouettes = 0;  ///< share of pixels with a covered and an empty pixel, or a step of depth, around them
};

Agreement compare(const FragmentImage& image, const FragmentImage& cast, float focalPixels) {
  size_t different = 0;
  size_t stray = 0;
  size_t silhouettes = 0;
  for (int y = 0; y < cast.height(); ++y) {
    for (int x = 0; x < cast.width(); ++x) {
      float least = 1e30f;
      float greatest = 0;
      bool anyCovered = false;
      bool anyEmpty = false;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, cast.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, cast.width() - 1); ++u) {
          const Fragment& f = cast(u, v);
          anyCovered = anyCovered || f.covered();
          anyEmpty = anyEmpty || !f.covered();
          if (f.covered()) {
            least = std::min(least, f.t);
            greatest = std::max(greatest, f.t);
          }
        }
      }
      const float footprint = greatest / focalPixels;
      // A step of more than 10 footprints between neighbours is no surface that shows its front.
      silhouettes += (anyCovered && anyEmpty) || greatest - least > 20 * footprint;
      const Fragment& f = image(x, y);
      different += f.covered() != cast(x, y).covered();
      // Between the rays around, give or take a footprint: what a facet between them may rise above them.
      stray += f.covered() ? !anyCovered || f.t < least - footprint || f.t > greatest + footprint : !anyEmpty;
    }
  }
  const auto pixels = static_cast<double>(cast.size());
  return {static_cast<double>(different) / pixels, static_cast<double>(stray) / pixels,
          static_cast<double>(silhouettes) / pixels};
}

void expectAgreement(const char* sceneName, const Mesh& mesh) {
  const PinholeCamera reference(View{}, kMatrixWidth, kMatrixHeight);
  const RayScene rays(mesh);
  forEachCamera(reference, mesh, [&](const char* cameraName, const auto& camera, double folds) {
    const FragmentImage cast = raycast(camera, mesh, rays);
    forEachTechnique(camera, mesh, [&](const char* techniqueName, const FragmentImage& image, const Bounds& bounds) {
      const Agreement found = compare(image, cast, reference.focalPixels());
      std::printf("%-8s %-5s %-10s  different %6.3f %%  stray %6.3f %%  silhouettes %6.2f %%\n", sceneName, cameraName,
                  techniqueName, 100 * found.different, 100 * found.stray, 100 * found.silhouettes);
      EXPECT_LE(found.stray, bounds.stray * found.silhouettes + folds)
          << sceneName << " " << cameraName << " " << techniqueName;
      EXPECT_LE(found.different, bounds.different * found.silhouettes + folds)
          << sceneName << " " << cameraName << " " << techniqueName;
      // An image that shows nothing would agree on every empty pixel.
      EXPECT_GT(found.silhouettes, 0) << sceneName << " " << cameraName;
    });
  });
}

TEST(TechniqueMatrix, sphere) {
  Mesh ball = makeSphere(64);
  for (glm::vec3& p : ball.positions) {
    p *= 0.8f;
  }
  expectAgreement("sphere", ball);
}

TEST(TechniqueMatrix, ballBeforePlane) {
  expectAgreement("ball", test::ballBeforePlane());
}

TEST(TechniqueMatrix, boxBeforeWall) {
  expectAgreement("box", test::boxBeforeWall(0.9f));
}

TEST(TechniqueMatrix, boxes) {
  expectAgreement("boxes", loadScene("builtin:boxes"));
}

TEST(TechniqueMatrix, teapot) {
  expectAgreement("teapot", loadScene("builtin:teapot"));
}

TEST(TechniqueMatrix, room) {
  expectAgreement("room", loadScene("builtin:room"));
}

}  // namespace
}  // namespace ocelli
