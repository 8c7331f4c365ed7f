#include "oc_core/ocri/construction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/eoc_builder.h"
#include "oc_core/ocri/spoc_builder.h"
#include "oc_core/render/displacement_reach.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::sameBytes;
using test::smallCamera;

const std::vector<std::string>& rayCameras() {
  static const std::vector<std::string> names{"di",    "spoc",  "di+spoc",     "ddoc",   "ddoc-constant",
                                              "eoc-h", "eoc-v", "eoc-forward", "eoc-hv", "eoc-hv+ddoc",
                                              "cell"};
  return names;
}

ReferenceImages build(const std::string& name, const Mesh& mesh, const RayScene* rays,
                      const PinholeCamera& camera = smallCamera()) {
  return buildReferenceImages(cameraChoice(name), camera, mesh, {},
                              rays != nullptr ? Construction::kRays : Construction::kRaster, rays);
}

TEST(Construction, isDecidedByTheStructureAndTheSizeOfTheScene) {
  struct Case {
    Construction wanted;
    size_t triangles;
    RayStructure structure;
    bool byRays;
  };
  constexpr size_t kCrossover = 1000;
  using enum RayStructure;
  for (const Case& each :
       {Case{Construction::kAuto, 999, kStands, false}, Case{Construction::kAuto, 1000, kStands, true},
        Case{Construction::kAuto, 999, kNone, false}, Case{Construction::kAuto, size_t{1} << 40, kNone, false},
        Case{Construction::kRaster, size_t{1} << 40, kStands, false}, Case{Construction::kRays, 0, kNone, true},
        Case{Construction::kRays, 0, kStands, true}, Case{Construction::kRays, 0, kRefits, true}}) {
    EXPECT_EQ(constructWithRays(each.wanted, kCrossover, each.triangles, each.structure), each.byRays)
        << static_cast<int>(each.wanted) << " " << each.triangles << " " << static_cast<int>(each.structure);
  }
}

// Rays of a quarter of the pixels cost a quarter, refitting as much as before.
TEST(Construction, ofWhatMovesIsDecidedByThePixelsToo) {
  constexpr size_t kPixels = 720 * 480;
  const auto byRays = [](size_t triangles, const RefitCost& refit) {
    return constructWithRays(Construction::kAuto, 1000, triangles, RayStructure::kRefits, refit);
  };
  EXPECT_FALSE(byRays(1999, {0.5, kPixels}));
  EXPECT_TRUE(byRays(2000, {0.5, kPixels}));
  EXPECT_FALSE(byRays(499, {0.5, kPixels / 4}));
  EXPECT_TRUE(byRays(500, {0.5, kPixels / 4}));
  EXPECT_FALSE(byRays(size_t{1} << 40, {1, kPixels})) << "drawing takes no longer than refitting";
}

TEST(Construction, isReadFromText) {
  EXPECT_EQ(constructionFromText("auto", "x"), Construction::kAuto);
  EXPECT_EQ(constructionFromText("raster", "x"), Construction::kRaster);
  EXPECT_EQ(constructionFromText("rays", "x"), Construction::kRays);
  EXPECT_THROW(constructionFromText("", "x"), InputError);
  EXPECT_THROW(constructionFromText("Rays", "x"), InputError);
}

TEST(Construction, isDescribed) {
  EXPECT_EQ(describe({}), "by rasterisation");
  EXPECT_EQ(describe({true, 1071000, 0.52}), "by rays (BVH of 1,071,000 triangles built in 0.5 s)");
  EXPECT_EQ(describe({true, 999, 0}), "by rays (BVH of 999 triangles at hand)");
}

TEST(Construction, autoTakesRaysWhereTheyAreFaster) {
  const Mesh mesh = test::boxBeforeWall();
  const RayScene rays(mesh);
  ConstructionReport report;
  const auto buildWith = [&](const char* name, Construction wanted, const RayScene* by) {
    buildReferenceImages(cameraChoice(name), smallCamera(), mesh, {}, wanted, by, &report);
  };
  buildWith("spoc", Construction::kAuto, &rays);
  EXPECT_TRUE(report.byRays) << "its crossover is 0";
  EXPECT_EQ(report.buildSeconds, 0);
  EXPECT_EQ(report.triangles, mesh.triangles.size());
  buildWith("spoc", Construction::kAuto, nullptr);
  EXPECT_FALSE(report.byRays);
  buildWith("ddoc", Construction::kAuto, &rays);
  EXPECT_FALSE(report.byRays) << "14 triangles";
  buildWith("rppc", Construction::kAuto, &rays);
  EXPECT_FALSE(report.byRays) << "has no construction by rays";
  buildWith("di", Construction::kRays, nullptr);
  EXPECT_TRUE(report.byRays);
  EXPECT_GT(report.buildSeconds, 0);
  for (const char* name : {"rppc", "di-wide", "corners-4", "ldi-4"}) {
    EXPECT_THROW(buildWith(name, Construction::kRays, &rays), InputError) << name;
  }
}

// Without a structure the viewpoints are checked, as for rasterisation; the ends of segments too.
TEST(Construction, raysRefuseViewpointsInsideObjects) {
  const Mesh mesh = test::boxBeforeWall();
  View view;
  view.fovVerticalDegrees = 30;
  view.eye = {0.1f, 0, 0.4f};
  const PinholeCamera inside(view, 30, 20);
  EXPECT_THROW(buildReferenceImages(cameraChoice("di"), inside, mesh, {}, Construction::kRays, nullptr), InputError);
  view.eye = {0.8f, 0, 0.4f};
  view.target = {0.8f, 0, 0};
  const PinholeCamera beside(view, 30, 20);
  EXPECT_THROW(buildReferenceImages(cameraChoice("eoc-h"), beside, mesh, {}, Construction::kRays, nullptr), InputError)
      << "0.8 to the left is the middle of the box";
}

/// Samples that one image has and the other has not, or that lie farther apart than rounding explains.
size_t differing(const ReferenceImage& a, const ReferenceImage& b) {
  // Floats of some hundreds and of about 10; on sides seen nearly edge-on some ten roundings of a barycentric weight.
  constexpr float kSamePixels = 5e-3f;
  constexpr float kSameRadii = 1e-3f;
  size_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const bool held = a.holds(x, y);
      count += held != (b.holds(x, y)) ||
               (held && (std::abs(a.t(x, y) - b.t(x, y)) > kSameRadii ||
                         glm::distance(a.displacement(x, y), b.displacement(x, y)) > kSamePixels));
    }
  }
  return count;
}

// A pinhole and a pole have closed rays, and so have epipolar cameras: only pixels that a silhouette just passes
// through may differ by rounding. The box has 4 sides of 19 pixels in the image, and none of its edges runs through a
// row of pixel centres.
TEST(Construction, exactRaysSeeWhatRasterisationDraws) {
  const Mesh mesh = test::boxBeforeWall();
  const RayScene rays(mesh);
  for (const char* name : {"di", "eoc-h", "eoc-v", "eoc-forward"}) {
    const ReferenceImage drawn = build(name, mesh, nullptr).front();
    const ReferenceImage cast = build(name, mesh, &rays).front();
    ASSERT_EQ(cast.width(), drawn.width()) << name;
    ASSERT_EQ(cast.height(), drawn.height()) << name;
    EXPECT_LE(differing(drawn, cast), 4u) << name;
    EXPECT_EQ(drawn.triangleBound, cast.triangleBound) << name;
  }
}

// Which tiles a cell camera stores hangs on every single sample, so that its image is compared for the same camera; one
// built by rays stores about as much. 1 %: the silhouette pixels of some satellites.
TEST(Construction, cellByRaysStoresTheSameSamples) {
  const Mesh mesh = test::boxBeforeWall();
  const RayScene rays(mesh);
  const RayRenderer renderer(mesh, rays);
  const CellCamera camera = buildCellCamera(smallCamera(), mesh);
  const ReferenceImage drawn = buildCellImage(camera, mesh);
  EXPECT_LE(differing(drawn, buildCellImage(camera, mesh, &renderer)), drawn.sampleCount() / 100);
  const CellCamera byRays = buildCellCamera(smallCamera(), mesh, {}, {}, &renderer);
  const ReferenceImage cast = buildCellImage(byRays, mesh, &renderer);
  EXPECT_GT(byRays.viewpoints().size(), 1u);
  EXPECT_NEAR(static_cast<double>(cast.sampleCount()), static_cast<double>(drawn.sampleCount()),
              0.01 * static_cast<double>(drawn.sampleCount()));
}

/// Whether pixel (x, y) or a neighbour shows something else than (x, y) does: a step of depth, or an empty sample.
bool atSilhouette(const ReferenceImage& image, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height() - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width() - 1); ++u) {
      if (std::abs(image.t(u, v) - image.t(x, y)) > 0.2f) {
        return true;
      }
    }
  }
  return false;
}

// Subdivision fills pieces of a pixel as if their edges were straight, and the rays of a sampled field are solved for:
// both are within a quarter of a pixel of each other where the field is smooth. Samples by a silhouette may go either
// way. (The discontinuous field of ddoc-constant folds, and there the two may choose different surfaces.)
TEST(Construction, sampledRaysSeeTheSameSurfaces) {
  const Mesh mesh = test::boxBeforeWall();
  const RayScene rays(mesh);
  for (const char* name : {"spoc", "ddoc"}) {
    const ReferenceImage drawn = build(name, mesh, nullptr).front();
    const ReferenceImage cast = build(name, mesh, &rays).front();
    ASSERT_EQ(cast.width(), drawn.width()) << name;
    ASSERT_EQ(cast.height(), drawn.height()) << name;
    EXPECT_EQ(drawn.triangleBound, cast.triangleBound) << name;
    size_t inner = 0;
    size_t differ = 0;
    for (int y = 0; y < drawn.height(); ++y) {
      for (int x = 0; x < drawn.width(); ++x) {
        if (atSilhouette(drawn, x, y) && atSilhouette(cast, x, y)) {
          continue;
        }
        ++inner;
        differ += std::abs(drawn.t(x, y) - cast.t(x, y)) > 0.2f ||
                  glm::distance(drawn.displacement(x, y), cast.displacement(x, y)) > 0.25f;
      }
    }
    EXPECT_GT(inner, drawn.t.size() / 2) << name;
    EXPECT_EQ(differ, 0u) << name;
  }
}

TEST(Construction, sameBytesForAnyThreadCount) {
  const Mesh mesh = test::ballBeforePlane();
  const RayScene rays(mesh);
  for (const std::string& name : rayCameras()) {
    setThreadCount(1);
    const ReferenceImages one = build(name, mesh, &rays);
    setThreadCount(5);
    const ReferenceImages five = build(name, mesh, &rays);
    setThreadCount(0);
    ASSERT_EQ(one.size(), five.size()) << name;
    for (size_t i = 0; i < one.size(); ++i) {
      EXPECT_TRUE(sameBytes(one[i].t, five[i].t)) << name;
      EXPECT_TRUE(sameBytes(one[i].color, five[i].color)) << name;
      EXPECT_TRUE(sameBytes(one[i].displacement, five[i].displacement)) << name;
    }
  }
}

TEST(Construction, emptyMeshGivesEmptyImages) {
  const Mesh nothing;
  const RayScene rays(nothing);
  const RayRenderer renderer(nothing, rays);
  const PinholeCamera camera = smallCamera();
  EXPECT_TRUE(rays.bounds().empty());
  EXPECT_EQ(buildDepthImage(camera, nothing, &renderer).sampleCount(), 0u);
  EXPECT_EQ(buildDdocImage(camera, nothing, {}, {}, &renderer).sampleCount(), 0u);
  EXPECT_EQ(buildCellImage(buildCellCamera(camera, nothing, {}, {}, &renderer), nothing, &renderer).sampleCount(), 0u);
  const ViewSegment segment = segmentAround(View{}, kHorizontalSegment, 1.6f);
  EXPECT_EQ(buildEocImage(camera, segment, nothing, {}, &renderer).sampleCount(), 0u);
  EXPECT_THROW(buildSpocCamera(camera, nothing, {}, &renderer), InputError);
  for (const std::string& name : rayCameras()) {
    EXPECT_THROW(build(name, nothing, &rays), InputError) << name << ": the view sees nothing";
  }
}

// The slow reference: every pixel is cast.
TEST(DisplacementReach, raysBeyondItAreThePinholes) {
  const Mesh mesh = test::ballBeforePlane();
  const RayScene rays(mesh);
  const PinholeCamera pinhole = smallCamera();
  const DdocCamera camera = buildDdocCamera(pinhole, mesh);
  const Image<uint8_t> reach = displacementReach(camera);
  size_t unreached = 0;
  for (int y = 0; y < pinhole.height(); ++y) {
    for (int x = 0; x < pinhole.width(); ++x) {
      if (reach(x, y) != 0) {
        continue;
      }
      ++unreached;
      const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      for (const float z : {2.0f, 9.3f, 10.0f, 11.0f, 50.0f}) {
        const ImagePoint q = camera.distort({pixel.x, pixel.y, z});
        EXPECT_EQ(glm::vec2(q.u, q.v), pixel) << z;
      }
    }
  }
  EXPECT_GT(unreached, reach.size() / 4) << "the ball covers less than a sixth of the image";
  // And nothing else is displaced there: from all over the image, and beyond its borders.
  for (float v = -20; v < static_cast<float>(pinhole.height()) + 20; v += 0.23f) {
    for (float u = -20; u < static_cast<float>(pinhole.width()) + 20; u += 0.23f) {
      for (const float z : {9.3f, 10.0f, 10.4f, 11.0f, 50.0f}) {
        const ImagePoint q = camera.distort({u, v, z});
        const int x = static_cast<int>(std::floor(q.u));
        const int y = static_cast<int>(std::floor(q.v));
        if ((q.u != u || q.v != v) && reach.contains(x, y)) {
          EXPECT_NE(reach(x, y), 0) << u << " " << v << " " << z;
        }
      }
    }
  }
  // What the unreached rays meet is what the pinhole saw.
  const FragmentImage seen = raycast(pinhole, mesh, rays);
  const FragmentImage whole = raycast(camera, mesh, rays);
  const FragmentImage part = unreachedPart(camera, seen);
  for (size_t i = 0; i < whole.size(); ++i) {
    if (part[i].covered()) {
      EXPECT_NEAR(part[i].t, whole[i].t, 1e-5f) << "rounding of floats of about 10";
    }
  }
}

TEST(RaySceneBounds, lieAroundTheMesh) {
  const Mesh mesh = test::ballBeforePlane();
  const Box box = RayScene(mesh).bounds();
  const Box expected = boundsOf(mesh);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.lower[axis], expected.lower[axis], 1e-5f);
    EXPECT_NEAR(box.upper[axis], expected.upper[axis], 1e-5f);
  }
}

}  // namespace
}  // namespace ocelli
